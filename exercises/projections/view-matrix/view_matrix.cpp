#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    // TODO: find the camera's axes x, y and z in world coordinates (it looks along -z, so z points from the target to
    // the eye), then write them into the rows of a matrix, and into its last column what moves the eye to the origin.
    // GLM stores columns: view[3][0] is the entry in row 0 and column 3. Mind an `up` that is (almost) parallel to the
    // view.
    return not_implemented<glm::mat4>(eye, target, up);
}

}
