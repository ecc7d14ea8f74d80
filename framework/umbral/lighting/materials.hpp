#pragma once

#include <cstdint>
#include <memory>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>
#include <vector>

namespace umbral::lighting {

/// What materials are activated on, and graphs drawn with: OpenGL, or a list of what was asked for. The course's Cauce.
class LitPipeline {
public:
    virtual ~LitPipeline() = default;

    /// What is drawn from now on reflects light so (fijarParamsMIL).
    virtual void set_reflection(const Material& reflection) = 0;
    /// ... and has this texture; 0 for none (fijarEvalText). Nothing else takes a texture away.
    virtual void set_texture(std::uint32_t texture) = 0;

    /// M := M · transformation (compMM).
    virtual void compose(const glm::mat4& transformation) = 0;
    /// Puts a copy of M on a stack (pushMM), and takes it from there (popMM). Reflection and texture are no part of it.
    virtual void push() = 0;
    virtual void pop() = 0;

    /// Draws a simple object.
    virtual void draw(std::uint32_t object) = 0;
};

/// A texture that several materials may share. It lives on the graphics card as long as this object.
class SharedTexture {
public:
    virtual ~SharedTexture() = default;
    /// Makes it the pipeline's texture; the first time, it sends its pixels.
    virtual void activate(LitPipeline& pipeline) = 0;
};

/// How a thing looks. Materials do not change; they know nothing of each other, nor of pipelines that they were
/// activated on before. Course: class Material.
class SurfaceMaterial {
public:
    virtual ~SurfaceMaterial() = default;
    /// From now on all is drawn with this reflection, and with this texture, or none: one call of set_reflection, and
    /// one of set_texture(0) or of the texture's activate. Course: Material::activar.
    virtual void activate(LitPipeline& pipeline) const = 0;
};

/// A material of any reflection. It owns the texture together with all others that have it: the texture goes when the
/// last of them is gone. A null pointer is no texture.
[[nodiscard]] std::unique_ptr<SurfaceMaterial> make_material(const Material& reflection,
                                                             std::shared_ptr<SharedTexture> texture);

/// The same from the course's four numbers: reflectances that are alike in red, green and blue, and the exponent; no
/// emission. Course: Material(Textura*, k_amb, k_dif, k_pse, exp_pse).
[[nodiscard]] std::unique_ptr<SurfaceMaterial> make_gray_material(float k_ambient, float k_diffuse, float k_specular,
                                                                  float exponent,
                                                                  std::shared_ptr<SharedTexture> texture);

/// One entry of a node. Course: EntradaNGE.
struct GraphEntry {
    enum class Kind : std::uint32_t { object, node, transformation, material };
    Kind kind = Kind::object;
    std::uint32_t index = 0;  ///< an object's name, any number; of others, the place in the graph's list
};

/// A scene graph: a node is a list of entries, in the order of drawing. A transformation acts on all that follows in
/// its own node. So does a material, up to the next one; it also reaches the nodes that are entered meanwhile, as far
/// as they have no material of their own. Neither acts on anything after the node's end. A node may be entered from
/// several places; none contains itself. All places are right. Course: NodoGrafoEscena.
struct MaterialGraph {
    std::vector<glm::mat4> transformations;
    std::vector<std::shared_ptr<const SurfaceMaterial>> materials;  ///< none is null; one may be there twice
    std::vector<std::vector<GraphEntry>> nodes;
    std::uint32_t root = 0;
};

/// Where a drawing stands. Course: ContextoVis.
struct DrawingContext {
    LitPipeline& pipeline;
    bool lighting = true;  ///< false: materials are passed over, and none is activated (cv.iluminacion)
    /// The material that is active on the pipeline (cv.material_act). With lighting on never null: the default material
    /// is activated before a graph is drawn.
    const SurfaceMaterial* material = nullptr;
};

/// Draws all objects that the root contains. Afterwards M, its stack, context.material and what is active on the
/// pipeline are as they were before.
///
/// Activates a material for an entry that names another than the active one, and once more at the end of a node that
/// changed it; or less often. Pushes and pops at most once a node. Course: NodoGrafoEscena::visualizarGL.
void draw_graph(const MaterialGraph& graph, DrawingContext& context);

}
