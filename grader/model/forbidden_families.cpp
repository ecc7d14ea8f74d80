#include "model/forbidden_families.hpp"

#include <algorithm>

namespace umbral::grader {

const std::vector<ForbiddenFamily>& forbidden_families()
{
    // A function belongs where it is declared, whatever it is called: macros round an include change names, and no
    // place.
    static const std::vector<ForbiddenFamily> families = {
        {"@transforms",
         "builds, applies or takes apart rotations, translations, scalings and projections",
         {"glm/ext/matrix_transform.*", "glm/ext/matrix_clip_space.*", "glm/ext/matrix_projection.*",
          "glm/ext/quaternion_*", "glm/detail/type_quat.*", "glm/gtc/matrix_transform.*", "glm/gtc/quaternion.*",
          "glm/gtx/transform.*", "glm/gtx/transform2.*", "glm/gtx/rotate_vector.*", "glm/gtx/rotate_normalized_axis.*",
          "glm/gtx/euler_angles.*", "glm/gtx/quaternion.*", "glm/gtx/dual_quaternion.*",
          "glm/gtx/matrix_transform_2d.*", "glm/gtx/matrix_interpolation.*", "glm/gtx/matrix_decompose.*",
          "glm/gtx/matrix_cross_product.*", "glm/gtx/matrix_operation.*"},
         {"glRotate*", "glTranslate*", "glScale*", "glOrtho*", "glFrustum*", "glMultMatrix*", "glLoadMatrix*",
          "glMultTransposeMatrix*", "glLoadTransposeMatrix*", "glMatrix*", "glu*"},
         {"glm::identity", "glm::adjugate"}},
        {"@vector-products",
         "multiplies, measures or normalizes vectors",
         {"glm/detail/func_geometric.*",    "glm/geometric.hpp",
          "glm/ext/quaternion_geometric.*", "glm/gtx/norm.*",
          "glm/gtx/vector_angle.*",         "glm/gtx/vector_query.*",
          "glm/gtx/perpendicular.*",        "glm/gtx/projection.*",
          "glm/gtx/orthonormalize.*",       "glm/gtx/normal.*",
          "glm/gtx/normalize_dot.*",        "glm/gtx/fast_square_root.*",
          "glm/gtx/exterior_product.*",     "glm/gtx/mixed_product.*",
          "glm/gtx/polar_coordinates.*",    "glm/gtx/closest_point.*",
          "glm/gtx/component_wise.*",       "glm/gtx/handed_coordinate_space.*",
          "glm/gtx/matrix_cross_product.*", "glm/gtx/intersect.*",
          "glm/gtx/rotate_vector.*",        "glm/detail/type_quat.*",
          "glm/ext/quaternion_*",           "glm/gtc/quaternion.*",
          "glm/gtx/quaternion.*",           "glm/gtx/dual_quaternion.*"},
         {},
         {}},
        {"@turns-between",
         "finds what lies between two turns",
         {"glm/ext/quaternion_common.*", "glm/ext/quaternion_exponential.*", "glm/gtx/quaternion.*",
          "glm/gtx/rotate_vector.*", "glm/gtx/matrix_interpolation.*", "glm/gtx/dual_quaternion.*"},
         {},
         {"glm::conjugate", "glm::inverse", "glm::lerp", "glm::isnan", "glm::isinf", "glm::rotate*", "glm::cross",
          "glm::to*", "glm::quat*", "glm::length*", "glm::extractRealComponent"}},
        {"@color-encoding",
         "encodes and decodes colours",
         {"glm/gtc/color_space.*", "glm/gtx/color_encoding.*", "glm/gtx/color_space.*"},
         {},
         {}}};
    return families;
}

const ForbiddenFamily* forbidden_family(std::string_view name)
{
    const auto found = std::ranges::find(forbidden_families(), name, &ForbiddenFamily::name);
    return found == forbidden_families().end() ? nullptr : &*found;
}

bool is_forbid_entry(std::string_view entry)
{
    return !entry.empty() && (entry.front() != '@' || forbidden_family(entry) != nullptr);
}

}
