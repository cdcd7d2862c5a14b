// What terrain_detail.glsl.h wants of GLSL.
#define SHADER
