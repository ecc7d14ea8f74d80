#include <emmintrin.h>
#include <umbral/transforms/vectors.hpp>
#undef GLM_ARCH
#define GLM_ARCH GLM_ARCH_SSE2
typedef __m128 glm_f32vec4; typedef __m128i glm_i32vec4; typedef __m128i glm_u32vec4; typedef __m128d glm_f64vec2; typedef __m128i glm_i64vec2; typedef __m128i glm_u64vec2; typedef glm_f32vec4 glm_vec4; typedef glm_i32vec4 glm_ivec4; typedef glm_u32vec4 glm_uvec4; typedef glm_f64vec2 glm_dvec2;
#include <glm/simd/common.h>
#include <glm/simd/geometric.h>
namespace umbral::transforms {
static __m128 l(const glm::vec3& a){ return _mm_set_ps(0,a.z,a.y,a.x); }
static glm::vec3 s(__m128 a){ float f[4]; _mm_storeu_ps(f,a); return {f[0],f[1],f[2]}; }
float dot_product(const glm::vec3& a, const glm::vec3& b) { return s(glm_vec4_dot(l(a),l(b))).x; }
glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b) { return s(glm_vec4_cross(l(a),l(b))); }
float length_of(const glm::vec3& v) { return s(glm_vec4_length(l(v))).x; }
glm::vec3 normalised(const glm::vec3& v) { float n=length_of(v); return n>0?v/n:v; }
float angle_between(const glm::vec3& a, const glm::vec3& b) { return std::atan2(length_of(cross_product(a,b)), dot_product(a,b)); }
glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b) { float q=dot_product(b,b); return q>0? dot_product(a,b)/q*b : glm::vec3(0); }
glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b) { return a-parallel_part(a,b); }
}
