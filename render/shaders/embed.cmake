# Writes OUTPUT, a C++ source that defines seaway::render::shaderSource for the shader FILES.
set(cases "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND cases "  if (name == \"${name}\") return R\"glsl(${text})glsl\";\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/gl/shader_sources.h\"

namespace seaway::render {

std::string_view shaderSource(std::string_view name) {
${cases}  return {};
}

}  // namespace seaway::render
")
