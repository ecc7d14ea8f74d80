// Based on: ISO/IEC 9592-1. Programmer's Hierarchical Interactive Graphics System (PHIGS). 1989: structures are shared
// by reference, and editing one of their elements changes all that is drawn with it.

#include <numbers>
#include <stdexcept>
#include <string>
#include <umbral/transforms/android.hpp>
#include <umbral/transforms/parametric_graph.hpp>
#include <utility>
#include <vector>

namespace umbral::transforms {
namespace {

glm::mat4 move(const glm::vec3& by) { return glm::translate(glm::mat4(1), by); }
glm::mat4 scale(float x, float y, float z) { return glm::scale(glm::mat4(1), {x, y, z}); }
glm::mat4 turn(float angle, const glm::vec3& axis) { return glm::rotate(glm::mat4(1), angle, axis); }

/// What is composed while it lives ends with it, also by way of an exception.
class PushedMatrix {
public:
    explicit PushedMatrix(Pipeline& pipeline) : pipeline_(pipeline) { pipeline_.push(); }
    PushedMatrix(const PushedMatrix&) = delete;
    PushedMatrix& operator=(const PushedMatrix&) = delete;
    ~PushedMatrix() { pipeline_.pop(); }

private:
    Pipeline& pipeline_;
};

class Node final : public GraphNode {
public:
    std::size_t add_object(std::shared_ptr<const Drawable> object) override
    {
        if (object == nullptr) throw std::invalid_argument("add_object: expected an object, got a null pointer");
        entries_.push_back({std::move(object), nullptr});
        return entries_.size() - 1;
    }

    std::size_t add_transformation(const glm::mat4& matrix) override
    {
        entries_.push_back({nullptr, std::make_unique<glm::mat4>(matrix)});
        return entries_.size() - 1;
    }

    glm::mat4* matrix_at(std::size_t index) override
    {
        if (index >= entries_.size())
            throw std::out_of_range("matrix_at: expected one of " + std::to_string(entries_.size()) + " entries, got " +
                                    std::to_string(index));
        glm::mat4* const matrix = entries_[index].matrix.get();
        if (matrix == nullptr)
            throw std::invalid_argument("matrix_at: expected a transformation, got an object at " +
                                        std::to_string(index));
        return matrix;
    }

    void draw(Pipeline& pipeline) const override
    {
        const PushedMatrix pushed(pipeline);
        for (const Entry& entry : entries_) {
            if (entry.object)
                entry.object->draw(pipeline);
            else
                pipeline.compose(*entry.matrix);
        }
    }

private:
    /// One of the two. The matrix has a place of its own, so that it stays there when the list of entries moves.
    struct Entry {
        std::shared_ptr<const Drawable> object;
        std::unique_ptr<glm::mat4> matrix;
    };
    std::vector<Entry> entries_;
};

/// A node of one object and what comes before it.
std::shared_ptr<GraphNode> placed(const glm::mat4& place, std::shared_ptr<const Drawable> object)
{
    auto node = std::make_shared<Node>();
    node->add_transformation(place);
    node->add_object(std::move(object));
    return node;
}

/// An arm or a leg, hanging from the origin; its first entry is free for motion.
std::shared_ptr<GraphNode> make_limb(const AndroidParts& parts)
{
    using namespace android_measures;
    const float r = limb_radius;
    const glm::mat4 upside_down = scale(r, -r, -r);
    auto limb = std::make_shared<Node>();
    limb->add_transformation(glm::mat4(1));
    limb->add_object(placed(scale(r, r, r), parts.half_sphere));
    limb->add_transformation(move({0, -limb_length, 0}));
    limb->add_object(placed(scale(r, limb_length, r), parts.cylinder));
    limb->add_object(placed(upside_down, parts.half_sphere));
    return limb;
}

/// The head, with its centre at the origin.
std::shared_ptr<GraphNode> make_head(const AndroidParts& parts)
{
    using namespace android_measures;
    auto head = std::make_shared<Node>();
    head->add_object(parts.half_sphere);
    const glm::mat4 facing = turn(std::numbers::pi_v<float> / 2, {1, 0, 0}) * scale(eye_radius, eye_radius, eye_radius);
    for (const float side : {1.0F, -1.0F})
        head->add_object(placed(move({side * eye.x, eye.y, eye.z}) * facing, parts.eye));
    for (const float side : {1.0F, -1.0F})
        head->add_object(placed(move({side * antenna.x, antenna.y, antenna.z}) * turn(-side * antenna_tilt, {0, 0, 1}) *
                                    scale(antenna_radius, antenna_length, antenna_radius),
                                parts.cylinder));
    return head;
}

/// Adds `object` at a place, with a joint there, whose matrix it returns.
glm::mat4* add_joint(GraphNode& node, const glm::vec3& place, std::shared_ptr<const Drawable> object)
{
    auto joint = std::make_shared<Node>();
    joint->add_transformation(move(place));
    const std::size_t index = joint->add_transformation(glm::mat4(1));
    joint->add_object(std::move(object));
    node.add_object(joint);
    return joint->matrix_at(index);
}

}

std::unique_ptr<GraphNode> make_graph_node() { return std::make_unique<Node>(); }

FacadeGraph make_facade(const FacadeParts& parts, float height, float angle)
{
    const auto root = std::make_shared<Node>();
    const std::size_t rotation = root->add_transformation(glm::mat4(1));
    const std::shared_ptr<GraphNode> house = placed(glm::mat4(1), parts.house);
    root->add_object(house);
    root->add_object(placed(move({0.56F, 0, 0}) * scale(0.3F, 0.43F, 1), parts.door));
    const std::shared_ptr<GraphNode> window = placed(scale(0.3F, 0.3F, 1), parts.window);
    for (const glm::vec3& step : {glm::vec3(0.13F, 0.13F, 0), glm::vec3(0, 0.43F, 0), glm::vec3(0.43F, 0, 0)}) {
        root->add_transformation(move(step));
        root->add_object(window);
    }
    FacadeGraph facade{root, root->matrix_at(rotation), house->matrix_at(0)};
    set_facade_height(facade, height);
    set_facade_angle(facade, angle);
    return facade;
}

void set_facade_height(const FacadeGraph& facade, float height) { *facade.stretch = scale(1, height / 1.5F, 1); }

void set_facade_angle(const FacadeGraph& facade, float angle) { *facade.rotation = turn(angle, {0, 0, 1}); }

AndroidGraph make_android_graph(const AndroidParts& parts)
{
    using namespace android_measures;
    const auto root = std::make_shared<Node>();
    const std::shared_ptr<GraphNode> limb = make_limb(parts);
    const auto add_limb = [&](float side, const glm::vec3& place) {
        return add_joint(*root, {side * place.x, place.y, place.z}, limb);
    };
    AndroidGraph android;
    root->add_object(placed(scale(1, body_height, 1), parts.cylinder));
    android.head = add_joint(*root, {0, head_height, 0}, make_head(parts));
    android.left_arm = add_limb(1, shoulder);
    android.right_arm = add_limb(-1, shoulder);
    add_limb(1, hip);
    add_limb(-1, hip);
    android.limb = limb->matrix_at(0);
    android.root = root;
    return android;
}

}
