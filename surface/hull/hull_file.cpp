#include "surface/hull/hull_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "surface/hull/file_axes.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

glm::dvec3 axisFrom(const std::string& word, const char* what) {
  const bool known =
      word.size() == 2 && (word[0] == '+' || word[0] == '-') && word[1] >= 'x' && word[1] <= 'z';
  if (!known) {
    throw InputError(std::string(what) + " is '" + word + "'; must be +x, -x, +y, -y, +z or -z");
  }
  glm::dvec3 axis(0.0);
  axis[word[1] - 'x'] = word[0] == '+' ? 1.0 : -1.0;
  return axis;
}

const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError(file.string() + ": is no file that can be read");
  }
  // Only places count: else corners that differ in normal or texture are not the same vertex.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_COLORS | aiComponent_TEXCOORDS |
                                  aiComponent_MATERIALS);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_RemoveComponent |
                         aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (!scene) {
    throw InputError(file.string() + ": cannot be read as a mesh: " + importer.GetErrorString());
  }
  return scene;
}

TriangleMesh gathered(const aiScene& scene, const glm::dmat3& toBody) {
  TriangleMesh mesh;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D& p = part.mVertices[v];
      mesh.vertices.push_back(toBody * glm::dvec3(p.x, p.y, p.z));
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      mesh.triangles.emplace_back(first + face.mIndices[0], first + face.mIndices[1],
                                  first + face.mIndices[2]);
    }
  }
  return mesh;
}

std::unique_ptr<aiScene> sceneOf(const TriangleMesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  auto part = std::make_unique<aiMesh>();
  part->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  part->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  part->mVertices = new aiVector3D[mesh.vertices.size()];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const glm::vec3 p(mesh.vertices[v]);
    part->mVertices[v] = {p.x, p.y, p.z};
  }
  part->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
  part->mFaces = new aiFace[mesh.triangles.size()];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    aiFace& face = part->mFaces[t];
    face.mNumIndices = 3;
    face.mIndices = new unsigned[3]{mesh.triangles[t].x, mesh.triangles[t].y, mesh.triangles[t].z};
  }
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { part.release() };
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mRootNode = new aiNode("hull");
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  return scene;
}

const char* formatOf(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".stl") return "stlb";
  if (ending == ".obj") return "objnomtl";
  if (ending == ".glb") return "glb2";
  throw InputError(file.string() + ": ends in '" + ending + "'; must end in .stl, .obj or .glb");
}

}  // namespace

glm::dmat3 bodyFromFile(const HullFileSettings& settings) {
  const glm::dvec3 forward = axisFrom(settings.forward, "forward");
  const glm::dvec3 up = axisFrom(settings.up, "up");
  if (glm::dot(forward, up) != 0.0) {
    throw InputError("forward '" + settings.forward + "' and up '" + settings.up +
                     "' lie along the same axis");
  }
  if (!(settings.metresPerUnit > 0.0) || !std::isfinite(settings.metresPerUnit)) {
    throw InputError("metres per unit must be > 0");
  }
  return settings.metresPerUnit * glm::transpose(glm::dmat3(forward, glm::cross(up, forward), up));
}

TriangleMesh readHullFile(const std::filesystem::path& file, const HullFileSettings& settings) {
  const glm::dmat3 toBody = bodyFromFile(settings);
  Assimp::Importer importer;
  const TriangleMesh mesh = gathered(*read(importer, file), toBody);
  if (mesh.triangles.empty()) throw InputError(file.string() + ": holds no triangle");
  for (const glm::dvec3& v : mesh.vertices) {
    if (std::isfinite(v.x + v.y + v.z)) continue;
    throw InputError(file.string() + ": has a coordinate that is not finite");
  }
  const glm::dvec3 size = boundsOf(mesh).size();
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0.0)) throw InputError(file.string() + ": all its vertices are one point");
  return welded(mesh, 1e-6 * longest);
}

void requireHullFormat(const std::filesystem::path& file) { formatOf(file); }

std::string hullFileBytes(const std::filesystem::path& file, const TriangleMesh& mesh) {
  const char* format = formatOf(file);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(sceneOf(mesh).get(), format);
  if (!blob) throw std::runtime_error(std::string("no mesh made: ") + exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

}  // namespace seaway
