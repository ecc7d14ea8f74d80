#include "operators.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace umbral::bench::scenes {
namespace {

template <class Kind>
struct Entry {
    Kind kind;
    Operator shown;
};

// Names are the enumerators' with blanks: GLSL gets its constants from here.
constexpr auto flaws = std::to_array<Entry<Flaw>>({
    {Flaw::missing_triangle, {"missing triangle", "One triangle of the mesh is not drawn."}},
    {Flaw::missing_edge, {"missing edge", "One line is not drawn."}},
    {Flaw::cracks, {"cracks", "Each triangle is a little too small, so that the background shows between neighbours."}},
    {Flaw::overlapping_seams,
     {"overlapping seams", "Triangles overlap at their common sides, where layers are then blended twice."}},
    {Flaw::front_faces_culled,
     {"front faces culled", "Wrong winding: triangles that face the viewer are thrown away."}},
    {Flaw::back_faces_shown, {"back faces shown", "Triangles that face away from the viewer are drawn too."}},
    {Flaw::flat_for_smooth, {"flat for smooth", "One normal for each triangle instead of interpolated ones."}},
    {Flaw::half_pixel_centre,
     {"half pixel centre",
      "Pixel centres are taken half a pixel too far to the upper left: all lies half a pixel off."}},
    {Flaw::sample_at_corner,
     {"sample at corner", "Pixels are sampled at their lower right corner instead of their centre."}},
    {Flaw::shifted_one_pixel, {"shifted one pixel", "All lies one pixel too far down: an index from 1 instead of 0."}},
    {Flaw::upside_down, {"upside down", "The first row of the picture is taken for the bottom one."}},
    {Flaw::mirrored, {"mirrored", "x grows to the left."}},
    {Flaw::rotation_sign, {"rotation sign", "Rotations go the other way round."}},
    {Flaw::transform_order, {"transform order", "Translation and rotation are multiplied in the wrong order."}},
    {Flaw::stale_frame, {"stale frame", "The previous step of the animation is shown."}},
    {Flaw::fov_3_percent_wrong, {"fov 3 percent wrong", "The angle of view is 3 % too large."}},
    {Flaw::aspect_ignored, {"aspect ignored", "The projection takes the picture for square."}},
    {Flaw::camera_1_percent_off,
     {"camera 1 percent off", "The camera stands 1 % of its distance too far to the side."}},
    {Flaw::near_plane_too_far, {"near plane too far", "The near plane cuts away what is close."}},
    {Flaw::far_plane_too_near, {"far plane too near", "The far plane cuts away what is distant."}},
    {Flaw::near_clipping_missing,
     {"near clipping missing", "Triangles that cross the near plane are dropped instead of clipped."}},
    {Flaw::z_fighting, {"z fighting", "The offset that keeps coplanar surfaces apart is missing."}},
    {Flaw::near_plane_tiny,
     {"near plane tiny", "The near plane lies so close to the eye that depth has no precision left in the distance."}},
    {Flaw::depth_inverted, {"depth inverted", "The depth test keeps what is farthest."}},
    {Flaw::depth_test_off, {"depth test off", "What is drawn last hides the rest."}},
    {Flaw::one_light_missing, {"one light missing", "The loop over the lights stops one too early."}},
    {Flaw::light_in_wrong_space,
     {"light in wrong space", "Lights are given in the world and used in eye space as they are."}},
    {Flaw::light_not_normalised,
     {"light not normalised", "The vector to the light keeps its length, up to twice a unit."}},
    {Flaw::attenuation_missing, {"attenuation missing", "Lights do not fall off with distance."}},
    {Flaw::spot_cone_missing, {"spot cone missing", "Spot lights shine in all directions."}},
    {Flaw::ambient_missing, {"ambient missing", "There is no ambient light."}},
    {Flaw::ambient_twice, {"ambient twice", "Ambient light is added twice."}},
    {Flaw::diffuse_missing, {"diffuse missing", "There is no diffuse term."}},
    {Flaw::specular_missing, {"specular missing", "There are no highlights."}},
    {Flaw::shininess_halved, {"shininess halved", "The exponent of the highlight is half of what it should be."}},
    {Flaw::phong_for_blinn, {"phong for blinn", "The highlight follows the reflected ray with Blinn's exponent."}},
    {Flaw::specular_behind, {"specular behind", "Highlights appear where the light is behind the surface."}},
    {Flaw::abs_cosine, {"abs cosine", "|n . l|: surfaces are lit from behind."}},
    {Flaw::negative_light, {"negative light", "n . l is not cut off at 0: light from behind is subtracted."}},
    {Flaw::normals_by_model,
     {"normals by model", "Normals are transformed by the matrix of positions, not by its inverse transpose."}},
    {Flaw::normal_matrix_transposed,
     {"normal matrix transposed", "The inverse of the matrix, without the transposition."}},
    {Flaw::normals_not_renormalised,
     {"normals not renormalised", "Interpolated normals are used although they are too short."}},
    {Flaw::viewer_fixed, {"viewer fixed", "The direction to the viewer is the camera's axis everywhere."}},
    {Flaw::one_band_too_few, {"one band too few", "The toon shading has one band too few."}},
    {Flaw::bands_rounded,
     {"bands rounded", "The bands of the toon shading are rounded to the nearest instead of down."}},
    {Flaw::affine_uv, {"affine uv", "Texture coordinates are interpolated without perspective."}},
    {Flaw::v_flipped, {"v flipped", "The texture stands on its head."}},
    {Flaw::u_mirrored, {"u mirrored", "The texture is mirrored."}},
    {Flaw::uv_scale_missing, {"uv scale missing", "Texture coordinates are not multiplied by the scale."}},
    {Flaw::clamp_for_repeat, {"clamp for repeat", "The texture is clamped to its edge instead of repeated."}},
    {Flaw::nearest_for_linear, {"nearest for linear", "The nearest texel instead of a blend of four."}},
    {Flaw::no_mipmaps, {"no mipmaps", "Distant texture is not filtered."}},
    {Flaw::half_texel_off,
     {"half texel off", "Texels are taken to lie on whole numbers: the texture is shifted by half a texel."}},
    {Flaw::bump_not_decoded, {"bump not decoded", "The normal map's 0 to 1 is not mapped to -1 to 1."}},
    {Flaw::bump_green_inverted,
     {"bump green inverted", "The normal map's y axis points the other way: bumps become dents."}},
    {Flaw::reflection_reversed,
     {"reflection reversed", "The ray to the eye is reflected instead of the ray from the eye."}},
    {Flaw::reflection_in_eye_space,
     {"reflection in eye space", "The reflected ray is not turned back into the world."}},
    {Flaw::blend_order, {"blend order", "Layers are blended from front to back."}},
    {Flaw::premultiplied_twice,
     {"premultiplied twice", "Colours are multiplied by alpha in the shader and again by the blending."}},
    {Flaw::alpha_ignored, {"alpha ignored", "Layers are opaque."}},
    {Flaw::additive_for_over, {"additive for over", "Layers are added instead of laid over."}},
    {Flaw::over_for_additive, {"over for additive", "Layers are laid over instead of added."}},
    {Flaw::depth_written_by_layers,
     {"depth written by layers",
      "Transparent layers write depth and are not drawn from back to front: some hide others."}},
    {Flaw::alpha_test_missing, {"alpha test missing", "The texture's empty parts are drawn."}},
    {Flaw::alpha_threshold_wrong, {"alpha threshold wrong", "The alpha test keeps only what is nearly opaque."}},
    {Flaw::fog_factor_wrong, {"fog factor wrong", "The fog's exponent is not squared."}},
    {Flaw::fog_missing, {"fog missing", "There is no fog."}},
    {Flaw::gamma_twice, {"gamma twice", "Colours are encoded twice: too pale."}},
    {Flaw::gamma_missing, {"gamma missing", "Colours are written without encoding: too dark."}},
    {Flaw::brightness_3_percent, {"brightness 3 percent", "All colours are 3 % too dark."}},
    {Flaw::brightness_5_percent, {"brightness 5 percent", "All colours are 5 % too dark."}},
    {Flaw::green_5_percent, {"green 5 percent", "Green is 5 % too dark."}},
    {Flaw::red_blue_swapped, {"red blue swapped", "BGR taken for RGB."}},
    {Flaw::sixteen_levels, {"sixteen levels", "An integer division leaves sixteen levels a channel."}},
    {Flaw::clamped_early, {"clamped early", "The sum of the lights is clamped before it is multiplied by the colour."}},
    {Flaw::wrapped_around, {"wrapped around", "Colours beyond white wrap around to black."}},
    {Flaw::blank, {"blank", "Nothing but the background."}},
    {Flaw::line_width_wrong, {"line width wrong", "Lines are twice as wide."}},
    {Flaw::steep_lines_gappy, {"steep lines gappy", "Lines take one pixel a column even where they are steep."}},
    {Flaw::line_end_missing, {"line end missing", "The last fifth of each line is not drawn."}},
    {Flaw::floor_for_round, {"floor for round", "Positions are rounded down instead of to the nearest."}},
    {Flaw::ends_both_filled,
     {"ends both filled", "Spans include the pixels beyond both of their ends: polygons grow by a pixel."}},
    {Flaw::vertex_counted_twice,
     {"vertex counted twice", "A scan line through a vertex counts both of its edges: streaks."}},
    {Flaw::last_edge_missing, {"last edge missing", "The edge from the last vertex to the first is forgotten."}},
    {Flaw::fan_for_polygon, {"fan for polygon", "A concave polygon is filled as a fan from its first vertex."}},
    {Flaw::cosine_missing, {"cosine missing", "Light is not weighted by the cosine at the surface."}},
    {Flaw::light_3_percent, {"light 3 percent", "The light is 3 % too weak."}},
    {Flaw::light_5_percent, {"light 5 percent", "The light is 5 % too weak."}},
    {Flaw::pdf_mismatch, {"pdf mismatch", "Directions are uniform, but weighted as if cosine-distributed."}},
    {Flaw::jitter_correlated,
     {"jitter correlated", "All pixels use the same random numbers: patterns instead of noise."}},
    {Flaw::shadow_missing, {"shadow missing", "No shadow rays are cast."}},
    {Flaw::light_as_point, {"light as point", "The light is sampled at its centre only: hard shadows."}},
    {Flaw::normal_forgotten, {"normal forgotten", "Directions are sampled round the vertical, not round the normal."}},
    {Flaw::aperture_halved, {"aperture halved", "The lens has half its radius: too sharp."}},
    {Flaw::pixel_not_jittered, {"pixel not jittered", "All samples go through the pixel's centre: jagged edges."}},
    {Flaw::bounce_missing, {"bounce missing", "Light that has bounced is not gathered."}},
    {Flaw::thing_missing, {"thing missing", "One thing of the scene is not drawn."}},
    {Flaw::thing_moved, {"thing moved", "One thing stands aside by 1 % of the camera's distance."}},
    {Flaw::thing_recoloured, {"thing recoloured", "One thing is a fifth darker, and a little redder."}},
    {Flaw::reflection_missing, {"reflection missing", "Mirrors reflect nothing."}},
    {Flaw::refraction_missing, {"refraction missing", "Light goes straight through glass."}},
});

constexpr auto ways = std::to_array<Entry<Way>>({
    {Way::other_renderer, {"other renderer", "Software against OpenGL: the same model, other arithmetic."}},
    {Way::other_gl_back_end, {"other gl back end", "EGL against OSMesa."}},
    {Way::not_optimised, {"not optimised", "Compiled without optimisation."}},
    {Way::fused_multiply_add, {"fused multiply add", "Compiled with -O3 and fused multiply-add."}},
    {Way::other_compiler, {"other compiler", "Compiled by clang++."}},
    {Way::double_precision, {"double precision", "Computed in double."}},
    {Way::triangles_reordered, {"triangles reordered", "The triangles of each mesh, or things, in another order."}},
    {Way::corners_rotated, {"corners rotated", "Each triangle begins at another of its corners."}},
    {Way::indexed_mesh, {"indexed mesh", "Equal corners are merged, and drawn by index."}},
    {Way::triangles_split, {"triangles split", "Each triangle is cut into three at its centre."}},
    {Way::stepwise_matrices, {"stepwise matrices", "Vertices go through model, view and projection one by one."}},
    {Way::equal_formulas, {"equal formulas", "The same formulas, written differently."}},
    {Way::light_in_world_space, {"light in world space", "Lighting is computed in the world instead of eye space."}},
    {Way::lights_reversed, {"lights reversed", "The lights are added in the opposite order."}},
    {Way::ends_swapped, {"ends swapped", "Lines and edges are walked from their other end."}},
    {Way::incremental_steps, {"incremental steps", "Positions along an edge are added up, not computed anew."}},
    {Way::fresh_seed_1, {"fresh seed 1", "Other random numbers."}},
    {Way::fresh_seed_2, {"fresh seed 2", "Other random numbers."}},
    {Way::fresh_seed_3, {"fresh seed 3", "Other random numbers."}},
    {Way::uniform_sampling,
     {"uniform sampling", "Uniform directions with the right weights, instead of cosine-distributed ones."}},
    {Way::stratified_samples, {"stratified samples", "One sample in each cell of a grid instead of independent ones."}},
    {Way::followed_by_rays, {"followed by rays", "Rays to the first surface instead of a rasteriser."}},
    {Way::world_moved, {"world moved", "Things, lights and camera are turned and moved together."}},
});

template <class Table, class Kind>
const Operator& entry(const Table& table, Kind kind)
{
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.kind == kind; });
    if (found == table.end())
        throw std::logic_error("umbral-bench-scenes: operator " + std::to_string(static_cast<int>(kind)) +
                               " has no entry in operators.cpp");
    return found->shown;
}

template <class Kind, class Table>
std::vector<Kind> kinds(const Table& table)
{
    std::vector<Kind> all;
    for (const auto& one : table) all.push_back(one.kind);
    return all;
}

}

const Operator& operator_of(Flaw flaw) { return entry(flaws, flaw); }
const Operator& operator_of(Way way) { return entry(ways, way); }

std::span<const Flaw> all_flaws()
{
    static const std::vector<Flaw> all = kinds<Flaw>(flaws);
    return all;
}

std::span<const Way> all_ways()
{
    static const std::vector<Way> all = kinds<Way>(ways);
    return all;
}

std::string joined(std::string_view name, char between)
{
    std::string text(name);
    std::replace(text.begin(), text.end(), ' ', between);
    return text;
}

}
