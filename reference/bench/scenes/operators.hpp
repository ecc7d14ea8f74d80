#pragma once

#include <span>
#include <string>
#include <string_view>

/// What may be done to a scene: bugs that a judge must see, and rewritings that it must let pass.
namespace umbral::bench::scenes {

/// A bug that students write. Painters state the wrong formula beside the right one.
enum class Flaw {
    none,
    // the mesh
    missing_triangle,
    missing_edge,
    cracks,
    overlapping_seams,
    front_faces_culled,
    back_faces_shown,
    flat_for_smooth,
    // where things are
    half_pixel_centre,
    sample_at_corner,
    shifted_one_pixel,
    upside_down,
    mirrored,
    rotation_sign,
    transform_order,
    stale_frame,
    fov_3_percent_wrong,
    aspect_ignored,
    camera_1_percent_off,
    near_plane_too_far,
    far_plane_too_near,
    near_clipping_missing,
    // depth
    z_fighting,
    near_plane_tiny,
    depth_inverted,
    depth_test_off,
    // light
    one_light_missing,
    light_in_wrong_space,
    light_not_normalised,
    attenuation_missing,
    spot_cone_missing,
    ambient_missing,
    ambient_twice,
    diffuse_missing,
    specular_missing,
    shininess_halved,
    phong_for_blinn,
    specular_behind,
    abs_cosine,
    negative_light,
    normals_by_model,
    normal_matrix_transposed,
    normals_not_renormalised,
    viewer_fixed,
    one_band_too_few,
    bands_rounded,
    // textures
    affine_uv,
    v_flipped,
    u_mirrored,
    uv_scale_missing,
    clamp_for_repeat,
    nearest_for_linear,
    no_mipmaps,
    half_texel_off,
    bump_not_decoded,
    bump_green_inverted,
    reflection_reversed,
    reflection_in_eye_space,
    // layers
    blend_order,
    premultiplied_twice,
    alpha_ignored,
    additive_for_over,
    over_for_additive,
    depth_written_by_layers,
    alpha_test_missing,
    alpha_threshold_wrong,
    fog_factor_wrong,
    fog_missing,
    // colours
    gamma_twice,
    gamma_missing,
    brightness_3_percent,
    brightness_5_percent,
    green_5_percent,
    red_blue_swapped,
    sixteen_levels,
    clamped_early,
    wrapped_around,
    blank,
    // lines and polygons in two dimensions
    line_width_wrong,
    steep_lines_gappy,
    line_end_missing,
    floor_for_round,
    ends_both_filled,
    vertex_counted_twice,
    last_edge_missing,
    fan_for_polygon,
    // Monte Carlo
    cosine_missing,
    light_3_percent,
    light_5_percent,
    pdf_mismatch,
    jitter_correlated,
    shadow_missing,
    light_as_point,
    normal_forgotten,
    aperture_halved,
    pixel_not_jittered,
    bounce_missing,
    // things in a scene
    thing_missing,
    thing_moved,
    thing_recoloured,
    reflection_missing,
    refraction_missing,
};

/// Another right way to draw the same picture.
enum class Way {
    as_it_is,
    other_renderer,
    other_gl_back_end,
    not_optimised,
    fused_multiply_add,
    other_compiler,
    double_precision,
    triangles_reordered,
    corners_rotated,
    indexed_mesh,
    triangles_split,
    stepwise_matrices,
    equal_formulas,
    light_in_world_space,
    lights_reversed,
    ends_swapped,
    incremental_steps,
    fresh_seed_1,
    fresh_seed_2,
    fresh_seed_3,
    uniform_sampling,
    stratified_samples,
    followed_by_rays,
    world_moved,
};

/// An operator's name, as files and tables have it, and a sentence for people.
struct Operator {
    std::string_view name;
    std::string_view about;
};

[[nodiscard]] const Operator& operator_of(Flaw flaw);
[[nodiscard]] const Operator& operator_of(Way way);

/// All flaws but `none`, in the order of the enumeration.
[[nodiscard]] std::span<const Flaw> all_flaws();
/// All ways but `as_it_is`.
[[nodiscard]] std::span<const Way> all_ways();

/// The name with another character for its blanks: "missing_triangle", "missing-triangle".
[[nodiscard]] std::string joined(std::string_view name, char between);

}
