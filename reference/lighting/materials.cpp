// Based on: the course's classes Material and NodoGrafoEscena; the graph is that of PHIGS (ISO/IEC 9592-1, 1989), whose
// structures hold attributes beside transformations.

#include <umbral/lighting/materials.hpp>
#include <utility>

namespace umbral::lighting {
namespace {

class ReflectionAndTexture final : public SurfaceMaterial {
public:
    ReflectionAndTexture(const Material& reflection, std::shared_ptr<SharedTexture> texture)
        : reflection_(reflection), texture_(std::move(texture))
    {
    }

    void activate(LitPipeline& pipeline) const override
    {
        pipeline.set_reflection(reflection_);
        // Without this, it would have the texture of the material before.
        texture_ ? texture_->activate(pipeline) : pipeline.set_texture(0);
    }

private:
    Material reflection_;
    std::shared_ptr<SharedTexture> texture_;
};

void use(DrawingContext& context, const SurfaceMaterial* material)
{
    if (material == context.material) return;
    context.material = material;
    material->activate(context.pipeline);
}

void draw_node(const MaterialGraph& graph, std::uint32_t node, DrawingContext& context)
{
    const SurfaceMaterial* const before = context.material;
    context.pipeline.push();
    for (const GraphEntry& entry : graph.nodes[node]) {
        switch (entry.kind) {
            case GraphEntry::Kind::object: context.pipeline.draw(entry.index); break;
            case GraphEntry::Kind::node: draw_node(graph, entry.index, context); break;
            case GraphEntry::Kind::transformation: context.pipeline.compose(graph.transformations[entry.index]); break;
            case GraphEntry::Kind::material:
                if (context.lighting) use(context, graph.materials[entry.index].get());
                break;
        }
    }
    context.pipeline.pop();
    use(context, before);
}

}

std::unique_ptr<SurfaceMaterial> make_material(const Material& reflection, std::shared_ptr<SharedTexture> texture)
{
    return std::make_unique<ReflectionAndTexture>(reflection, std::move(texture));
}

std::unique_ptr<SurfaceMaterial> make_gray_material(float k_ambient, float k_diffuse, float k_specular, float exponent,
                                                    std::shared_ptr<SharedTexture> texture)
{
    const Material gray{glm::vec3(0), glm::vec3(k_ambient), glm::vec3(k_diffuse), glm::vec3(k_specular), exponent};
    return make_material(gray, std::move(texture));
}

void draw_graph(const MaterialGraph& graph, DrawingContext& context) { draw_node(graph, graph.root, context); }

}
