#include "surface/hull/coloured_mesh.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "surface/hull/file_axes.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

/// Notes what a file refers to and what of it is not there: readers go on without.
class NotingFiles final : public Assimp::DefaultIOSystem {
 public:
  using Names = std::vector<std::string>;
  explicit NotingFiles(std::shared_ptr<Names> missing) : missing_(std::move(missing)) {}
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    Assimp::IOStream* stream = DefaultIOSystem::Open(file, mode);
    if (stream) {
      missing_->clear();  // what was looked for elsewhere before
    } else {
      missing_->push_back(file);
    }
    return stream;
  }

 private:
  std::shared_ptr<Names> missing_;
};

/// Names of materials that stand for none.
bool isDefault(const aiMaterial& material) {
  aiString name;
  material.Get(AI_MATKEY_NAME, name);
  return name.length == 0 || std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME;
}

std::optional<glm::vec3> colourOf(const aiMaterial& material) {
  if (isDefault(material)) return std::nullopt;
  aiColor4D colour;
  const bool known = material.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS ||
                     material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS;
  if (!known) return std::nullopt;
  return glm::clamp(glm::vec3(colour.r, colour.g, colour.b), 0.0f, 1.0f);
}

/// Textures that a material names must be there, though they are not drawn.
void checkTextures(const aiMaterial& material, const std::filesystem::path& file,
                   std::vector<std::string>& remarks) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    aiString name;
    if (material.GetTexture(type, 0, &name) != AI_SUCCESS) continue;
    const std::string text = name.C_Str();
    const bool inside = !text.empty() && text[0] == '*';  // within a GLB
    const std::filesystem::path texture = file.parent_path() / text;
    if (!inside && !std::filesystem::is_regular_file(texture)) {
      throw InputError(file.string() + ": its texture is missing: " + texture.string());
    }
    const std::string shown = inside ? "a texture inside the file" : texture.string();
    remarks.push_back(file.string() + ": " + shown +
                      " is not drawn; the material's base colour is");
    return;
  }
}

glm::dvec3 vertexOf(const aiMesh& mesh, unsigned i, const glm::dmat3& toBody) {
  const aiVector3D& p = mesh.mVertices[i];
  return toBody * glm::dvec3(p.x, p.y, p.z);
}

/// Triangles with area; `left` counts those without.
TriangleMesh partOf(const aiMesh& part, const glm::dmat3& toBody, const std::string& file,
                    std::size_t& left) {
  TriangleMesh mesh;
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    mesh.vertices.push_back(vertexOf(part, v, toBody));
    const glm::dvec3& p = mesh.vertices.back();
    if (std::isfinite(p.x + p.y + p.z)) continue;
    throw InputError(file + ": has a coordinate that is not finite");
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) {
      ++left;
      continue;
    }
    const TriangleMesh::Triangle t(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
    if (glm::length(areaVector(mesh, t)) > 0.0) {
      mesh.triangles.push_back(t);
    } else {
      ++left;
    }
  }
  return mesh;
}

const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError(file.string() + ": is no file that can be read");
  }
  const auto missing = std::make_shared<NotingFiles::Names>();
  importer.SetIOHandler(new NotingFiles(missing));  // the importer owns it, to its end
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_COLORS | aiComponent_TEXCOORDS);
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_RemoveComponent |
                                           aiProcess_PreTransformVertices);
  const std::string reason = importer.GetErrorString();
  if (!missing->empty()) {
    throw InputError(file.string() + ": refers to a file that is missing: " + missing->front());
  }
  if (!scene) throw InputError(file.string() + ": cannot be read as a mesh: " + reason);
  return scene;
}

}  // namespace

ColouredMesh readColouredMesh(const std::filesystem::path& file, const HullFileSettings& settings) {
  const glm::dmat3 toBody = bodyFromFile(settings);
  Assimp::Importer importer;
  const aiScene& scene = *read(importer, file);
  ColouredMesh result;
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    checkTextures(*scene.mMaterials[m], file, result.remarks);
  }
  std::size_t left = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    TriangleMesh mesh = partOf(part, toBody, file.string(), left);
    if (mesh.triangles.empty()) continue;
    result.parts.push_back({std::move(mesh), colourOf(*scene.mMaterials[part.mMaterialIndex])});
  }
  if (result.parts.empty()) {
    throw InputError(file.string() +
                     (left > 0 ? ": holds no triangle that has an area" : ": holds no triangle"));
  }
  if (left > 0) {
    result.remarks.push_back(file.string() + ": " + std::to_string(left) +
                             " faces without area are not drawn");
  }
  return result;
}

}  // namespace seaway
