// SPDX-License-Identifier: Apache-2.0
#include "geometry/assimp_generators.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <chrono>
#include <stdexcept>
#include <string>

namespace rakelight::bench {
namespace {

aiMesh* to_assimp(const BenchPart& part) {
    const unsigned corners = unsigned(part.indices.size());
    aiMesh* mesh = new aiMesh;
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = corners;
    mesh->mVertices = new aiVector3D[corners];
    mesh->mTextureCoords[0] = new aiVector3D[corners];
    mesh->mNumUVComponents[0] = 2;
    mesh->mNumFaces = corners / 3;
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    for (unsigned i = 0; i < corners; ++i) {
        const vec3 p = part.positions[part.indices[i]];
        const vec2 q = part.texcoords[part.indices[i]];
        mesh->mVertices[i] = {p.x, p.y, p.z};
        mesh->mTextureCoords[0][i] = {q.x, q.y, 0};
    }
    for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
        mesh->mFaces[f].mNumIndices = 3;
        mesh->mFaces[f].mIndices = new unsigned[3]{3 * f, 3 * f + 1, 3 * f + 2};
    }
    return mesh;
}

// A reader that hands out the model, so that the importer owns it as one that came from a file.
class ModelReader : public Assimp::BaseImporter {
public:
    explicit ModelReader(const BenchModel& model) : model_(model) {}
    bool CanRead(const std::string& file, Assimp::IOSystem*, bool) const override {
        return file.ends_with("benchmodel");
    }
    const aiImporterDesc* GetInfo() const override {
        static const aiImporterDesc description = {"model", "", "", "", 0, 0, 0, 0, 0, "benchmodel"};
        return &description;
    }

protected:
    void InternReadFile(const std::string&, aiScene* scene, Assimp::IOSystem*) override {
        const unsigned count = unsigned(model_.parts.size());
        scene->mNumMaterials = 1;
        scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
        scene->mNumMeshes = count;
        scene->mMeshes = new aiMesh*[count];
        scene->mRootNode = new aiNode("root");
        scene->mRootNode->mNumMeshes = count;
        scene->mRootNode->mMeshes = new unsigned[count];
        for (unsigned m = 0; m < count; ++m) {
            scene->mMeshes[m] = to_assimp(model_.parts[m]);
            scene->mRootNode->mMeshes[m] = m;
        }
    }

private:
    const BenchModel& model_;
};

}  // namespace

AssimpSeconds assimp_generators(const BenchModel& model) {
    Assimp::Importer importer;
    importer.RegisterLoader(new ModelReader(model));  // the importer's own from here on
    const auto check = [&](const aiScene* scene) {
        if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
        return scene;
    };
    check(importer.ReadFileFromMemory("model", 5, 0, "benchmodel"));
    const auto timed = [&](unsigned step) {
        const auto start = std::chrono::steady_clock::now();
        check(importer.ApplyPostProcessing(step));
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    AssimpSeconds seconds;
    seconds.normals = timed(aiProcess_GenSmoothNormals);
    seconds.tangents = timed(aiProcess_CalcTangentSpace);
    const aiMesh* const first = importer.GetScene()->mMeshes[0];
    if (!first->HasNormals() || !first->HasTangentsAndBitangents())
        throw std::runtime_error("Assimp made no attributes");
    return seconds;
}

}  // namespace rakelight::bench
