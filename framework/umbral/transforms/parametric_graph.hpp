#pragma once

#include <cstddef>
#include <memory>
#include <umbral/transforms/pipeline.hpp>

namespace umbral::transforms {

/// What can be drawn: a simple object, or a graph of them. Drawing is neutral. Course: Objeto3D.
class Drawable {
public:
    virtual ~Drawable() = default;
    virtual void draw(Pipeline& pipeline) const = 0;
};

/// A node of a scene graph: a list of entries, objects and transformations, in the order of drawing. A transformation
/// acts on all that follows in its own node, and on nothing outside. A node is an object itself, and may be an entry of
/// others; no node contains itself. Course: NodoGrafoEscena.
class GraphNode : public Drawable {
public:
    /// Adds an entry behind all others, and returns its index: 0, 1, 2, …. The object is shared, not copied: it may be
    /// an entry of many nodes, and many times of one. Throws std::invalid_argument, and adds nothing, if it is null.
    /// Course: agregar(Objeto3D *).
    virtual std::size_t add_object(std::shared_ptr<const Drawable> object) = 0;
    /// The same with a copy of a matrix. Course: agregar(const Matriz4f &).
    virtual std::size_t add_transformation(const glm::mat4& matrix) = 0;

    /// The matrix of a transformation's entry, in the graph: whoever writes to it changes what is drawn from then on.
    /// The pointer stays right as long as the node lives, whatever is added later. Throws std::out_of_range if there is
    /// no such entry, std::invalid_argument if it is an object. Course: leerPtrMatriz.
    [[nodiscard]] virtual glm::mat4* matrix_at(std::size_t index) = 0;

    /// Draws all entries in order; neutral, also if an object throws: its exception goes on, but matrix and depth of
    /// the stack are as before. Course: NodoGrafoEscena::visualizarGL.
    void draw(Pipeline& pipeline) const override = 0;
};

/// A node without entries; it shares nothing with those made before.
[[nodiscard]] std::unique_ptr<GraphNode> make_graph_node();

/// What a facade is made of, each in its own coordinates; none is null.
struct FacadeParts {
    std::shared_ptr<const Drawable> house;  ///< from (0, 0) to (1, 1.5)
    std::shared_ptr<const Drawable> door;
    std::shared_ptr<const Drawable> window;
};

/// A graph with two degrees of freedom, and where its parameters stand. The pointers point into the graph, and hold
/// while `root` lives.
struct FacadeGraph {
    std::shared_ptr<GraphNode> root;
    glm::mat4* rotation = nullptr;  ///< of the whole facade
    glm::mat4* stretch = nullptr;   ///< of the house alone
};

/// The course's facade, in this order: the rotation; the house, stretched; the door at (0.56, 0), of size (0.3, 0.43);
/// three windows of size (0.3, 0.3), at (0.13, 0.13), (0.13, 0.56) and (0.56, 0.56). House, door and windows all turn.
/// Height and angle as for the setters. Course: FachadaP.
[[nodiscard]] FacadeGraph make_facade(const FacadeParts& parts, float height, float angle);

/// The house's height is to be `height` (fijarH): the scaling (1, height / 1.5, 1). It sets; it does not add.
void set_facade_height(const FacadeGraph& facade, float height);
/// The facade stands turned by `angle` radians about the axis z, counter-clockwise (fijarAlpha). It sets.
void set_facade_angle(const FacadeGraph& facade, float angle);

/// What an android is made of; none is null.
struct AndroidParts {
    std::shared_ptr<const Drawable> half_sphere;  ///< as Primitive::half_sphere
    std::shared_ptr<const Drawable> cylinder;     ///< as Primitive::cylinder
    std::shared_ptr<const Drawable> eye;          ///< a half sphere in white
};

/// The android as a graph, and the matrices by which it moves, all of them the identity at first. They stand in the
/// graph, and hold while `root` lives.
struct AndroidGraph {
    std::shared_ptr<GraphNode> root;
    glm::mat4* left_arm = nullptr;   ///< about the centre of its upper half sphere
    glm::mat4* right_arm = nullptr;  ///< likewise
    glm::mat4* head = nullptr;       ///< about the head's centre, with eyes and antennae
    glm::mat4* limb = nullptr;       ///< about the centre of the upper half sphere of *each* arm and leg, before all
                                     ///< else: the limb is one node, which the graph contains four times
};

/// The android of transforms/android at rest: its measures (android_measures), its 18 solids, its order of drawing.
/// Course: problem 2.24, its PHIGS graph.
[[nodiscard]] AndroidGraph make_android_graph(const AndroidParts& parts);

}
