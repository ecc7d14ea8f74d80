// What happens to a vertex and to a fragment, right and wrong. One text for two languages: GLSL compilers read it behind a few definitions
// (opengl.cpp), C++ compilers as the inside of a struct (shading.hpp). So painters share the model and differ in rounding only.

struct Lamp {
    vec4 place;  // where light is computed: eye space or world
    vec3 color;
    vec3 falloff;
    vec3 aim;
    Real cone;
    Real focus;
};

struct Placed {
    vec4 clip;
    vec3 place;
    vec3 normal;
};

struct Surface {
    vec3 place;
    vec3 normal;
    vec2 uv;
    vec2 affine;  // uv without perspective
    vec4 color;
    Real lod;
};

uniform Choice flaw;
uniform Manner way;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat4 all_matrices;
uniform mat4 lit_in;  // to where light is computed
uniform mat3 normal_matrix;
uniform mat3 to_world;
uniform vec4 viewer;
uniform vec2 moved;
uniform Real depth_offset;
uniform vec3 ambient;
uniform vec4 paint;
uniform vec3 specular;
uniform Real shininess;
uniform int style;
uniform Real bands;
uniform vec2 uv_scale;
uniform vec2 texel;
uniform int textured;
uniform int alpha_test;
uniform int encoded;
uniform vec3 fog_color;
uniform Real fog_density;
uniform int lamp_count;
uniform Lamp lamps[5];

Placed placed(vec3 position, vec3 direction)
{
    vec4 p = vec4(position, Real(1));
    Placed result;
    result.clip = way == stepwise_matrices ? projection * (view * (model * p)) : all_matrices * p;
    result.clip.x += moved.x * result.clip.w;
    result.clip.y += moved.y * result.clip.w;
    result.clip.z -= depth_offset * result.clip.w;
    result.place = vec3(lit_in * p);
    result.normal = normalize(normal_matrix * direction);
    return result;
}

Real highlight(Real cosine)
{
    Real c = max(cosine, Real(0));
    if (way == equal_formulas) return c > Real(0) ? exp2(shininess * log2(c)) : Real(0);
    return pow(c, shininess);
}

Real specular_share(vec3 n, vec3 l, vec3 v)
{
    if (flaw == phong_for_blinn) return highlight(dot(reflect(-l, n), v));
    vec3 sum = l + v;
    if (way == equal_formulas) return highlight(dot(n, sum) / sqrt(dot(sum, sum)));
    return highlight(dot(n, normalize(sum)));
}

// How much of a light arrives: attenuation and cone.
Real arriving(Lamp lamp, Real d, vec3 l)
{
    Real share = Real(1);
    if (lamp.place.w != Real(0) && flaw != attenuation_missing) {
        vec3 f = lamp.falloff;
        share = way == equal_formulas ? Real(1) / (f.x + d * (f.y + d * f.z)) : Real(1) / (f.x + f.y * d + f.z * d * d);
    }
    if (lamp.cone < Real(-1) || flaw == spot_cone_missing) return share;
    Real c = -dot(l, lamp.aim);
    return c < lamp.cone ? Real(0) : share * pow(c, lamp.focus);
}

vec3 lit(vec3 n, vec3 place, vec3 albedo)
{
    vec3 v = viewer.w == Real(0) ? vec3(viewer) : normalize(vec3(viewer) - place);
    if (flaw == viewer_fixed) v = transpose(to_world) * vec3(view[0][2], view[1][2], view[2][2]);
    vec3 diffuse_light = ambient;
    vec3 shine = vec3(Real(0));
    for (int k = 0; k < lamp_count; ++k) {
        Lamp lamp = lamps[way == lights_reversed ? lamp_count - 1 - k : k];
        vec3 l = vec3(lamp.place);
        Real d = Real(1);
        if (lamp.place.w != Real(0)) {
            l = l - place;
            d = length(l);
            l = l / d;
        }
        vec3 light = lamp.color * arriving(lamp, d, l);
        if (flaw == light_not_normalised) l = l * min(d, Real(2));
        Real cosine = dot(n, l);
        if (flaw == abs_cosine) cosine = abs(cosine);
        if (style == 2) {
            Real steps = flaw == one_band_too_few ? bands - Real(1) : bands;
            Real band = max(cosine, Real(0)) * steps;
            cosine = (flaw == bands_rounded ? floor(band + Real(0.5)) : min(floor(band) + Real(1), steps)) / steps;
            if (dot(n, l) <= Real(0)) cosine = Real(0);
        }
        if (flaw != diffuse_missing) diffuse_light += light * (flaw == negative_light ? cosine : max(cosine, Real(0)));
        if (flaw != specular_missing && (cosine > Real(0) || flaw == specular_behind)) shine += light * specular_share(n, l, v);
    }
    if (flaw == clamped_early) diffuse_light = min(diffuse_light, vec3(Real(1)));
    return albedo * diffuse_light + specular * shine;
}

// What a mirror sees: a tiled floor, and a sky that grows paler towards the horizon.
vec3 surroundings(vec3 r)
{
    Real t = max(r.y, Real(0));
    vec3 sky = mix(vec3(Real(0.85), Real(0.80), Real(0.70)), vec3(Real(0.12), Real(0.25), Real(0.60)), sqrt(t));
    vec3 sun = normalize(vec3(Real(0.5), Real(0.6), Real(0.6)));
    sky += vec3(Real(0.9), Real(0.8), Real(0.5)) * smoothstep(Real(0.93), Real(0.96), dot(r, sun));
    vec2 floor_at = vec2(r.x, r.z) / max(-r.y, Real(0.05));
    Real tile = floor(floor_at.x) + floor(floor_at.y);
    Real odd = tile - Real(2) * floor(tile * Real(0.5));
    vec3 ground = mix(vec3(Real(0.45), Real(0.12), Real(0.08)), vec3(Real(0.70), Real(0.62), Real(0.50)), odd);
    return r.y >= Real(0) ? sky : ground;
}

vec3 mirrored_in(vec3 n, vec3 place)
{
    vec3 from_eye = normalize(place - vec3(viewer));
    vec3 r = way == equal_formulas ? from_eye - (Real(2) * dot(n, from_eye)) * n : reflect(from_eye, n);
    if (flaw == reflection_reversed) r = -r;
    vec3 seen = surroundings(flaw == reflection_in_eye_space ? r : to_world * r);
    return vec3(paint) * seen;
}

vec2 texture_place(Surface at)
{
    vec2 uv = flaw == affine_uv ? at.affine : at.uv;
    if (flaw != uv_scale_missing) uv = uv * uv_scale;
    if (flaw == v_flipped) uv.y = Real(1) - uv.y;
    if (flaw == u_mirrored) uv.x = Real(1) - uv.x;
    if (flaw == half_texel_off) uv = uv + Real(0.5) * texel;
    return uv;
}

// Normal maps here lie on surfaces that face +z of their own space, with u along x.
vec3 bumped(vec3 stored)
{
    vec3 m = flaw == bump_not_decoded ? stored : Real(2) * stored - vec3(Real(1));
    if (flaw == bump_green_inverted) m.y = -m.y;
    return normalize(normal_matrix * m);
}

Real fog_share(vec3 place)
{
    Real reach = fog_density * length(place - vec3(viewer));
    if (flaw == fog_factor_wrong) return exp(-reach);
    return way == equal_formulas ? Real(1) / exp(reach * reach) : exp(-(reach * reach));
}

vec3 finished(vec3 linear)
{
    vec3 c = linear;
    if (flaw == brightness_3_percent) c = c * Real(0.97);
    if (flaw == brightness_5_percent) c = c * Real(0.95);
    if (flaw == wrapped_around) c = fract(c);
    c = clamp(c, Real(0), Real(1));
    Real exponent = Real(1);
    if (encoded == 1 && flaw != gamma_missing) exponent = Real(1) / Real(2.2);
    if (flaw == gamma_twice) exponent = exponent / Real(2.2);
    if (exponent != Real(1)) c = way == equal_formulas ? exp2(exponent * log2(max(c, vec3(Real(0.0000001))))) : pow(c, vec3(exponent));
    if (flaw == green_5_percent) c.y = c.y * Real(0.95);
    if (flaw == sixteen_levels) c = floor(c * Real(15.999)) / Real(15);
    return c;
}

// The colour of a fragment and how much it covers; below 0: nothing at all.
vec4 shaded(Surface at)
{
    vec4 albedo = at.color * paint;
    vec3 n = flaw == normals_not_renormalised ? at.normal : normalize(at.normal);
    if (textured == 1) {
        vec4 t = lookup(texture_place(at), at.lod);
        if (style == 4) {
            n = bumped(vec3(t));
        } else {
            if (encoded == 1) t = vec4(pow(vec3(t), vec3(Real(2.2))), t.w);
            albedo = albedo * t;
        }
    }
    if (alpha_test == 1 && flaw != alpha_test_missing) {
        if (albedo.w < (flaw == alpha_threshold_wrong ? Real(0.95) : Real(0.5))) return vec4(Real(-1));
        albedo.w = Real(1);
    }
    vec3 c = vec3(albedo);
    if (style == 3) c = mirrored_in(n, at.place);
    if (style == 1 || style == 2 || style == 4) c = lit(n, at.place, vec3(albedo));
    if (fog_density > Real(0) && flaw != fog_missing) {
        Real kept = fog_share(at.place);
        c = way == equal_formulas ? kept * c + (Real(1) - kept) * fog_color : mix(fog_color, c, kept);
    }
    Real alpha = flaw == alpha_ignored ? Real(1) : albedo.w;
    c = finished(c);
    return vec4(flaw == premultiplied_twice ? c * alpha : c, alpha);
}
