#include "embree.hpp"

#include <cstring>
#include <stdexcept>

namespace umbral::raytrace::bench {
namespace {

RTCRay as_embrees(const Ray& ray)
{
    RTCRay made{};
    made.org_x = ray.origin.x;
    made.org_y = ray.origin.y;
    made.org_z = ray.origin.z;
    made.dir_x = ray.direction.x;
    made.dir_y = ray.direction.y;
    made.dir_z = ray.direction.z;
    made.tnear = ray.t_min;
    made.tfar = ray.t_max;
    made.mask = ~0U;
    return made;
}

}

EmbreeScene::EmbreeScene(std::span<const Corners> triangles)
    : device_(rtcNewDevice("threads=1"), rtcReleaseDevice), scene_(nullptr, rtcReleaseScene)
{
    if (!device_) throw std::runtime_error("Embree could not be started");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
    const RTCGeometry mesh = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            3 * triangles.size());
    static_assert(sizeof(Corners) == 3 * sizeof(glm::vec3));
    std::memcpy(corners, triangles.data(), triangles.size_bytes());
    auto* numbers = static_cast<unsigned*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), triangles.size()));
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) numbers[i] = static_cast<unsigned>(i);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_.get(), mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_.get());
}

Hit EmbreeScene::first_hit(const Ray& ray) const
{
    RTCRayHit asked{as_embrees(ray), {}};
    asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &asked);
    if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {asked.hit.primID, asked.ray.tfar, asked.hit.u, asked.hit.v};
}

bool EmbreeScene::is_blocked(const Ray& ray) const
{
    RTCRay asked = as_embrees(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_.get(), &context, &asked);
    return asked.tfar < 0;
}

}
