#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/camera.h"
#include "render/frame.h"
#include "surface/effects.h"
#include "surface/water_surface.h"

namespace seaway::render {

class HeadlessContext;

/// How the sun glitters on water.
enum class Specular : int {
  slopes = 0,  ///< over the slopes of facets that the pixel cannot show (Cox & Munk 1954): default
  phong = 1,   ///< Phong's lobe about the mirrored ray, exponent 256, times Fresnel (Johanson 2004)
  toman = 2,   ///< Toman's term, brighter where water reflects less, shininess 0.6
};

/// How water dims what is seen through it.
enum class Extinction {
  exponential,  ///< Beer and Lambert: e^(−3 d/D), D the distance of full extinction of a colour
  linear,       ///< Toman's 1 − d/D, nothing beyond D
};

/// Normals that face away from the viewer, on the back sides of waves.
enum class BackFaces {
  tilt,  ///< are turned towards the viewer until they are seen edge-on (Kryachko 2005): default
  keep,  ///< are shaded as they are
};

/// Rival terms of shading, by those who proposed them.
struct ShadingTerms {
  Specular specular = Specular::slopes;
  Extinction extinction = Extinction::exponential;
  BackFaces backFaces = BackFaces::tilt;
};

/// How radiance, times the exposure, becomes what a display shows, each colour by itself.
enum class ToneCurve : int {
  filmic = 0,    ///< Narkowicz' fit (2015) of the ACES curve: dark tones darker, lights rolled off
  reinhard = 1,  ///< x (1 + x/16) / (1 + x): white at 4 (Reinhard et al. 2002, equation 4)
  linear = 2,    ///< as it is, white from 1 on
};

struct Moon {
  double elevation = 0.5;  ///< rad above the horizon
  double direction = 0.0;  ///< rad counter-clockwise from east: where it stands
  double phase = 0.5;      ///< [0, 1]: 0 new, 0.5 full, 1 new again
};

/// Light that all techniques share.
struct Light {
  double sunElevation = 0.5;  ///< rad above the horizon, [−π/2, π/2]
  double sunDirection = 0.0;  ///< rad counter-clockwise from east: where the sun stands
  double windSpeed = 7.0;     ///< m/s at 12.5 m: roughness below the field's shortest waves
  double turbidity = 0.045;  ///< of the water, 1/m ≥ 0: what it dims beyond clear water, any colour
  double visibility = 28e3;  ///< m, > 0: where haze leaves 2 % of a thing's contrast
  std::optional<Moon> moon{};
  ShadingTerms terms{};
  ToneCurve toneCurve = ToneCurve::filmic;
  /// Colours are rounded up or down by a pattern of their pixel, at most one step of 255 off what
  /// they would be, so that slow gradients show no bands; radiance, depth and labels are not.
  bool dithers = false;
};

/// A lamp: a point of light, seen within an arc.
struct Lamp {
  glm::dvec3 position{0.0};        ///< in the sea plane's frame, m
  glm::vec3 colour{1.0f};          ///< linear
  double candela = 10.0;           ///< luminous intensity
  glm::dvec3 towards{1, 0, 0};     ///< middle of its arc, unit
  glm::dvec3 up{0, 0, 1};          ///< normal of the plane of its arc, unit
  double arc = 6.283185307179586;  ///< rad, from edge to edge; 2π: all round
  bool shines = false;             ///< on things about it too: it has no screens
};

/// A plain coloured triangle mesh in its own body frame (x forward, y port, z up, m).
struct Mesh {
  struct Part {
    std::vector<glm::vec3> vertices;  ///< three a triangle, counter-clockwise seen from outside
    glm::vec3 colour{0.8f};           ///< linear reflectance
  };
  /// A convex room inside the hull that keeps the sea out: a cockpit, a hold. Where the surface of
  /// the sea passes through it, no sea is drawn.
  struct Hollow {
    /// Outward unit normal in xyz, distance from the body origin in w: inside, dot(n, p) < w for
    /// all.
    std::vector<glm::vec4> planes;  ///< at most `mostPlanes`
    static constexpr std::size_t mostPlanes = 12;
  };
  std::vector<Part> parts;
  std::vector<Hollow> hollows;
  double boundingRadius = 0.0;  ///< about the body origin, m
};

/// What a scene object is, and so which effect draws it.
enum class ObjectKind {
  vessel,   ///< Effect::vesselMeshes
  scenery,  ///< Effect::scenery
};

/// A mesh placed in the sea plane's frame.
struct SceneObject {
  const Mesh* mesh = nullptr;
  glm::dvec3 position{0.0};
  glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};
  std::uint16_t instance = 0;  ///< what Frame::instances calls it; 0: not told from the rest
  ObjectKind kind = ObjectKind::vessel;
};

/// Everything a technique draws: no graphics library in sight.
struct View {
  const WaterSurface* water = nullptr;
  double time = 0.0;  ///< s since the scene's epoch
  Camera camera;
  Light light;
  std::span<const SceneObject> objects;
  std::span<const Lamp> lamps;      ///< shown when it is dusk or dark
  EffectLedger* effects = nullptr;  ///< decides what is drawn; required
  bool wantsNormals = false;        ///< fill Frame::normals
  bool wantsRadiance = false;       ///< fill Frame::radiance
  bool wantsLabels = false;         ///< fill Frame::instances and Frame::foam
  /// Each pixel's colour is the mean radiance of this many by as many: by techniques of
  /// makeTechnique(), others refuse more than 1.
  int samplesPerSide = 1;
  FrameContents contents() const { return {wantsNormals, wantsRadiance, wantsLabels}; }
  /// The camera that a projected grid is placed for, where it is not `camera`: to look at a grid
  /// from elsewhere, and to see what changes as it moves.
  const Camera* gridCamera = nullptr;
};

/// Throws InputError unless the camera is in range and a pinhole, seen once a pixel.
void validatePlain(const View& view);

/// One way to draw the sea and what floats on it.
class RenderTechnique {
 public:
  virtual ~RenderTechnique() = default;
  virtual std::string name() const = 0;

  /// Draws `view` into `frame`, whose memory is used again. The technique owns what it draws with
  /// and reuses it between frames; a context it was made with must outlive it. Not thread-safe.
  virtual void drawInto(const View& view, Frame& frame) = 0;

  /// The same into a frame of its own.
  Frame draw(const View& view) {
    Frame frame;
    drawInto(view, frame);
    return frame;
  }
};

/// How the projected grid gets from the field to pixels; the picture is the same but for rounding,
/// for rims of objects (OpenGL's are smoothed along their edges alone, those of `software` are
/// mixed by the part of the pixel that they cover) and for what cpuVerticesGpuNormals says.
enum class GridVariant {
  cpuVertices,  ///< heights and vertices by the processor, mesh through GL
  gpu,          ///< heights by the graphics card, vertices displaced by texture fetch
  /// An eighth of the vertices each way by the processor, slopes at all points of the grid by the
  /// graphics card. Depth and outline are the coarse mesh's, as in Johanson's variant of that name:
  /// only shading has the grid's detail.
  cpuVerticesGpuNormals,
  marched,   ///< heights by the graphics card, a ray for each pixel, no mesh
  software,  ///< raster and shading by the processor too: no GL at all
};
/// Name as on the command line: "cpu_vertices", "software".
std::string_view gridVariantName(GridVariant variant);

/// How finely the projected grid samples the sea, and by which variant.
struct ProjectedGridOptions {
  glm::ivec2 grid{256, 256};        ///< vertices across, vertices along; ≥ 2 each
  double projectorElevation = 1.0;  ///< least height of the projector above the highest wave, m
  GridVariant variant = GridVariant::cpuVertices;
  /// False: the picture stays on the graphics card, the frame carries statistics alone, and passes
  /// are not waited for.
  bool readBack = true;
};

/// Johanson's projected grid (2004) without OpenGL: `options.variant` is not looked at. The fastest
/// where the only OpenGL is software. Threads of TBB's pool share the work; the picture does not
/// depend on how many there are.
std::unique_ptr<RenderTechnique> makeSoftwareGrid(const ProjectedGridOptions& options = {});

/// How the naive grid lies around the camera.
struct NaiveGridOptions {
  glm::ivec2 grid{256, 256};  ///< vertices eastwards and northwards; ≥ 2 each
  double side = 2000.0;       ///< m: beyond half of it there is no sea
};

/// An even grid of the sea plane around the camera's foot, drawn as the software projected grid is.
/// Kept to show why not: what is near is coarse, what is far is missing, most is out of view.
std::unique_ptr<RenderTechnique> makeNaiveGrid(const NaiveGridOptions& options = {});

/// How the radial grid lies around the camera, and what displaces it.
struct RadialGridOptions {
  glm::ivec2 grid{256, 256};   ///< spokes, rings; ≥ 3 each
  double innermost = 0.1;      ///< radius of the first ring, m, > 0
  double displacement = 0.99;  ///< share of the waves' variance that displaces vertices, (0, 1]
};

/// Kryachko's radial grid (2005, GPU Gems 2, chapter 18): rings about the camera's foot at radii
/// a₀ + a₁ i⁴ out to the horizon. Heights are those of the largest octaves, slopes, for lighting,
/// those of all that the ring carries, both gathered in one table of floats, a texel a vertex. What
/// the camera cannot see is not sampled. Drawn as the software projected grid is.
std::unique_ptr<RenderTechnique> makeRadialGrid(const RadialGridOptions& options = {});

/// How the sea is found in a pass over all pixels.
struct PostProcessOptions {
  glm::ivec2 grid{256, 256};  ///< of the height map: spokes, rings; ≥ 3 each
  int steps = 16;             ///< of the march, [2, 1024]
};

/// Toman's water as a post-process: the scene is drawn first, then a pass over all pixels marches
/// from each one's scene position towards the viewer over a height map, to where the ray last
/// leaves the water, and takes normals from four neighbours in the map. The map lies on the radial
/// grid's rings, all waves that they carry in it. A crest that lies between two steps is not seen.
std::unique_ptr<RenderTechnique> makePostProcess(const PostProcessOptions& options = {});

/// A ray through each pixel's centre against the same sea, curved like it: the truth that other
/// techniques' pictures and depths are compared with. Slow. `options.grid` says for which grid: the
/// waves that its rows cannot carry are left out here too (reference/band_limited_sea.h, which
/// states tolerances). Shaded by the same text.
std::unique_ptr<RenderTechnique> makeReference(const ProjectedGridOptions& options = {});

/// Johanson's projected grid (2004), drawn through the context.
std::unique_ptr<RenderTechnique> makeProjectedGrid(HeadlessContext& context,
                                                   const ProjectedGridOptions& options = {});

}  // namespace seaway::render
