#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"

/// What both OpenGL renderers hand to the driver. All need a current context, and delete what they made.
namespace umbral::render {

/// A mesh in the memory of the graphics card: a vertex array object, vertices and indices.
class MeshBuffers {
public:
    explicit MeshBuffers(const VertexMesh& mesh);
    MeshBuffers(const MeshBuffers&) = delete;
    MeshBuffers& operator=(const MeshBuffers&) = delete;
    ~MeshBuffers();

    /// From now on pointers to attributes mean this mesh's vertices.
    void bind() const;
    /// Draws all triangles; bind() comes before.
    void draw() const;

private:
    int count_;
    unsigned array_ = 0;
    std::array<unsigned, 2> buffers_{};
};

/// A texture of floats with its filter and wrap modes, without levels of detail.
class TextureObject {
public:
    explicit TextureObject(const Texture& texture);
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;
    ~TextureObject();

    void bind() const;

private:
    unsigned texture_ = 0;
};

/// Which meshes and textures of a list something that can be seen uses; `textured`: are textures looked up at all?
struct Needed {
    std::vector<bool> meshes;
    std::vector<bool> textures;
};
[[nodiscard]] Needed needed_objects(const DrawList& list, bool textured);

/// Those objects, at the same places as in the list. What is not needed is never made, and its place is empty.
struct DrawObjects {
    std::vector<std::unique_ptr<MeshBuffers>> meshes;
    std::vector<std::unique_ptr<TextureObject>> textures;
};
[[nodiscard]] DrawObjects make_objects(const DrawList& list, bool textured);

/// Draws one instance by `draw_it`, which hands its triangles over, and adds to `work` what that was, if it is given.
void draw_counted(const DrawList& list, const Draw& draw, const EffectSet& effects, OpenGlWork* work,
                  const std::function<void()>& draw_it);
/// Adds what a picture has once: objects, lights, and what is outside.
void count_once(const DrawList& list, const DrawObjects& objects, const EffectSet& effects, OpenGlWork* work);

/// Depth test "less", no blending, back faces culled or not, front faces counter-clockwise before the picture is turned
/// upside down (and clockwise for what is mirrored).
void set_depth_test();
void set_faces(const Draw& draw);

}
