// bench-rays: building the engine's hierarchy and following rays in it, beside Embree: one thread each, in turns in one
// run, so that their ratios hold on a busy machine too.
//   bench-rays [--quick]

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <functional>
#include <thread>

#include "embree.hpp"
#include "meshes.hpp"

namespace umbral::raytrace::bench {
namespace {

double seconds_of(const std::function<void()>& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Medians of the two's times and of their ratios, pair by pair.
struct Compared {
    double ours, embrees, ratio;
};

Compared compare(int rounds, const std::function<void()>& ours, const std::function<void()>& embrees)
{
    std::vector<Compared> all;
    for (int i = 0; i < rounds; ++i) {
        const double a = seconds_of(ours);
        const double b = seconds_of(embrees);
        all.push_back({a, b, b / a});
    }
    const auto median = [&](double Compared::*value) {
        std::ranges::sort(all, {}, value);
        return all[all.size() / 2].*value;
    };
    return {median(&Compared::ours), median(&Compared::embrees), median(&Compared::ratio)};
}

void print(const char* what, std::size_t count, const Compared& compared)
{
    fmt::print("  {:<26} {:>8.2f} {:>8.2f} million/s   {:.2f}\n", what,
               1e-6 * static_cast<double>(count) / compared.ours, 1e-6 * static_cast<double>(count) / compared.embrees,
               compared.ratio);
}

void measure_rays(const char* what, const std::vector<Ray>& rays, bool any, int rounds, const Hierarchy& hierarchy,
                  const EmbreeScene& embree)
{
    std::size_t met = 0;
    const auto ask = [&](const auto& is_blocked, const auto& first) {
        return [&, is_blocked, first] {
            for (const Ray& ray : rays) met += any ? is_blocked(ray) : first(ray).triangle != Hit::nothing;
        };
    };
    const auto ours = ask([&](const Ray& ray) { return is_blocked(hierarchy, ray); },
                          [&](const Ray& ray) { return first_hit(hierarchy, ray); });
    const auto theirs = ask([&](const Ray& ray) { return embree.is_blocked(ray); },
                            [&](const Ray& ray) { return embree.first_hit(ray); });
    print(what, rays.size(), compare(rounds, ours, theirs));
    // What is counted must be looked at, or there is nothing to be measured.
    if (met == 0) fmt::print("  (none of these rays meets anything)\n");
}

/// Two threads that take some rays at a time, as the engine's take tiles, beside one that follows all; and the same of
/// Embree: where it gains no more, it is the machine's memory that two threads share.
void measure_threads(const std::vector<Ray>& rays, int rounds, const Hierarchy& hierarchy, const EmbreeScene& embree)
{
    const auto gain = [&](const auto& first) {
        const auto follow = [&](int threads) {
            std::atomic<std::size_t> next = 0;
            const auto work = [&] {
                constexpr std::size_t at_a_time = 4096;
                std::size_t met = 0;
                for (std::size_t begin = next.fetch_add(at_a_time); begin < rays.size();
                     begin = next.fetch_add(at_a_time))
                    for (std::size_t i = begin; i < std::min(begin + at_a_time, rays.size()); ++i)
                        met += first(rays[i]).triangle != Hit::nothing;
                return met;
            };
            std::vector<std::jthread> others;
            for (int i = 1; i < threads; ++i) others.emplace_back([&] { (void)work(); });
            (void)work();
        };
        return compare(
                   rounds, [&] { follow(2); }, [&] { follow(1); })
            .ratio;
    };
    fmt::print("  {:<26} {:.2f} times as fast as one; Embree {:.2f}\n", "two threads, diffuse rays",
               gain([&](const Ray& ray) { return first_hit(hierarchy, ray); }),
               gain([&](const Ray& ray) { return embree.first_hit(ray); }));
}

void measure(int rings, int side, int rounds)
{
    const std::vector<Corners> triangles = hilly_sphere(rings);
    Hierarchy hierarchy;
    std::unique_ptr<EmbreeScene> embree;
    const Compared build = compare(
        std::max(1, rounds / 4), [&] { hierarchy = make_hierarchy(triangles); },
        [&] { embree = std::make_unique<EmbreeScene>(triangles); });
    fmt::print("{} triangles, {:.0f} bytes each; by {}\n", triangles.size(),
               static_cast<double>(hierarchy.bytes()) / static_cast<double>(triangles.size()),
               traversals().front().name);
    fmt::print("  {:<26} {:>8} {:>8}             Embree's time over ours\n", "", "ours", "Embree");
    print("triangles built", triangles.size(), build);
    const std::vector<Ray> primary = primary_rays(side);
    measure_rays("primary rays", primary, false, rounds, hierarchy, *embree);
    measure_rays("shadow rays", second_rays(hierarchy, primary, true), true, rounds, hierarchy, *embree);
    measure_rays("diffuse rays", second_rays(hierarchy, primary, false), false, rounds, hierarchy, *embree);
    measure_rays("random rays", random_rays(primary.size()), false, rounds, hierarchy, *embree);
    measure_threads(second_rays(hierarchy, primary, false), rounds, hierarchy, *embree);
}

}
}

int main(int count, char** words)
{
    using umbral::raytrace::bench::measure;
    const bool quick = count == 2 && std::strcmp(words[1], "--quick") == 0;
    if (count > 1 && !quick) {
        (void)std::fputs("bench-rays [--quick]: rays of the engine beside Embree's\n", stderr);
        return 2;
    }
    if (quick) {
        measure(60, 128, 3);
        return 0;
    }
    measure(400, 512, 15);
    measure(1118, 512, 9);
    return 0;
}
