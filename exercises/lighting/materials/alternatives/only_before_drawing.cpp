// alternative: activates a material right before an object is drawn with it, and not earlier
#include <umbral/lighting/materials.hpp>
#include <utility>

namespace umbral::lighting {
namespace {

class Matter final : public SurfaceMaterial {
public:
    Material reflection;
    std::shared_ptr<SharedTexture> texture;

    void activate(LitPipeline& pipeline) const override
    {
        if (texture)
            texture->activate(pipeline);
        else
            pipeline.set_texture(0);
        pipeline.set_reflection(reflection);
    }
};

class Painter {
public:
    Painter(const MaterialGraph& graph, DrawingContext& context) : graph_(graph), context_(context) {}

    void visit(std::uint32_t node, const SurfaceMaterial* material)
    {
        bool moved = false;
        for (const GraphEntry& entry : graph_.nodes[node]) {
            if (entry.kind == GraphEntry::Kind::object) {
                make_active(material);
                context_.pipeline.draw(entry.index);
            } else if (entry.kind == GraphEntry::Kind::node) {
                visit(entry.index, material);
            } else if (entry.kind == GraphEntry::Kind::material) {
                if (context_.lighting) material = graph_.materials[entry.index].get();
            } else {
                if (!moved) context_.pipeline.push();
                moved = true;
                context_.pipeline.compose(graph_.transformations[entry.index]);
            }
        }
        if (moved) context_.pipeline.pop();
    }

    void make_active(const SurfaceMaterial* material)
    {
        if (!context_.lighting || material == context_.material) return;
        material->activate(context_.pipeline);
        context_.material = material;
    }

private:
    const MaterialGraph& graph_;
    DrawingContext& context_;
};

}

std::unique_ptr<SurfaceMaterial> make_material(const Material& reflection, std::shared_ptr<SharedTexture> texture)
{
    auto matter = std::make_unique<Matter>();
    matter->reflection = reflection;
    matter->texture = std::move(texture);
    return matter;
}

std::unique_ptr<SurfaceMaterial> make_gray_material(float k_ambient, float k_diffuse, float k_specular, float exponent,
                                                    std::shared_ptr<SharedTexture> texture)
{
    Material reflection;
    reflection.ambient = glm::vec3(k_ambient);
    reflection.diffuse = glm::vec3(k_diffuse);
    reflection.specular = glm::vec3(k_specular);
    reflection.shininess = exponent;
    return make_material(reflection, std::move(texture));
}

void draw_graph(const MaterialGraph& graph, DrawingContext& context)
{
    const SurfaceMaterial* const before = context.material;
    Painter painter(graph, context);
    painter.visit(graph.root, before);
    painter.make_active(before);
}

}
