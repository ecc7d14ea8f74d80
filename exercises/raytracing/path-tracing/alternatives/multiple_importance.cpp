// alternative: in double, one lamp at random for each reflection, and both ways to find it weighted by the balance
// heuristic
#include <algorithm>
#include <cmath>
#include <numbers>
#include <umbral/raytracing/path_tracing.hpp>

namespace umbral::raytracing {
namespace {

struct Basis {
    glm::dvec3 x, y, z;
    explicit Basis(const glm::dvec3& normal) : z(normalize(normal))
    {
        const glm::dvec3 other = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        x = normalize(cross(other, z));
        y = cross(z, x);
    }
};

double weight_of(double chosen, double other) { return chosen / (chosen + other); }

class Tracer {
public:
    Tracer(const DiffuseScene& scene, Random& random) : scene_(scene), random_(random) {}

    glm::dvec3 path(Ray ray, int bounces)
    {
        glm::dvec3 light(0);
        glm::dvec3 throughput(1);
        double density = 0;
        for (int bounce = 0; bounce <= bounces; ++bounce) {
            const std::optional<DiffusePoint> hit = scene_.first_hit(ray);
            if (!hit) {
                light += throughput * glm::dvec3(scene_.sky(ray.direction));
                break;
            }
            double weight = 1;
            if (bounce > 0 && hit->lamp >= 0) {
                const AreaLamp& lamp = scene_.lamps()[static_cast<std::size_t>(hit->lamp)];
                weight = weight_of(density, lamp_density(ray.origin, lamp, hit->position) / lamps());
            }
            light += weight * throughput * glm::dvec3(hit->emitted);
            if (bounce == bounces) break;
            throughput *= glm::dvec3(hit->albedo);
            if (!scene_.lamps().empty()) light += throughput * towards_a_lamp(*hit);
            if (bounce > 4) {
                const double survival = std::min(0.9, (throughput.x + throughput.y + throughput.z) / 3 + 0.05);
                if (random_.uniform_double() > survival) break;
                throughput /= survival;
            }
            const glm::vec3 direction = cosine_direction(hit->normal, random_);
            density = cosine_density(hit->normal, direction);
            ray = Ray{hit->position, direction};
        }
        return light;
    }

private:
    double lamps() const { return static_cast<double>(scene_.lamps().size()); }

    glm::dvec3 towards_a_lamp(const DiffusePoint& at)
    {
        const AreaLamp& lamp = scene_.lamps()[random_.below(static_cast<std::uint32_t>(scene_.lamps().size()))];
        const float a = random_.uniform();
        const glm::vec3 place = lamp.corner + a * lamp.edge_a + random_.uniform() * lamp.edge_b;
        const glm::vec3 direction = normalize(place - at.position);
        const double reflected = cosine_density(at.normal, direction);
        if (reflected <= 0 || dot(cross(lamp.edge_a, lamp.edge_b), direction) >= 0) return glm::dvec3(0);
        if (scene_.blocked(at.position, place)) return glm::dvec3(0);
        const double density = lamp_density(at.position, lamp, place) / lamps();
        return glm::dvec3(lamp.radiance) * (reflected / density * weight_of(density, reflected));
    }

    const DiffuseScene& scene_;
    Random& random_;
};

}

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    const Basis basis(normal);
    const double angle = 2 * std::numbers::pi * random.uniform_double();
    const double cosine = std::sqrt(1 - random.uniform_double());
    const double sine = std::sqrt(1 - cosine * cosine);
    return glm::vec3(sine * std::cos(angle) * basis.x + sine * std::sin(angle) * basis.y + cosine * basis.z);
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    return static_cast<float>(std::max(0.0, dot(glm::dvec3(normal), glm::dvec3(direction))) / std::numbers::pi);
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    const glm::dvec3 normal = cross(glm::dvec3(lamp.edge_a), glm::dvec3(lamp.edge_b));
    const glm::dvec3 way = glm::dvec3(on_lamp) - glm::dvec3(point);
    const double cosine = std::abs(dot(normalize(normal), normalize(way)));
    return static_cast<float>(dot(way, way) / (length(normal) * cosine));
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    Tracer tracer(scene, random);
    glm::dvec3 sum(0);
    for (int i = 0; i < samples; ++i) sum += tracer.path(ray, bounces);
    return glm::vec3(sum / static_cast<double>(samples));
}

}
