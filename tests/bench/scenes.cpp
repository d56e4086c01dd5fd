#include "tests/bench/scenes.hpp"

#include "core/engine/domain/add_loop.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace forefront::bench {

namespace {

constexpr double kTriangle = 0.4330127018922193; ///< area of an equilateral triangle of side 1: √3/4

std::vector<Vec2> rectangle(double width, double height) {
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// Returns a closed curve with a wavy edge; `phase` shifts the waves.
std::vector<Vec2> coast(Vec2 centre, double radius, int nodes, double waviness, double phase) {
    std::vector<Vec2> line;
    for (int i = 0; i < nodes; ++i) {
        const double t = 2.0 * std::numbers::pi * i / nodes;
        const double r = radius * (1.0 + waviness * (std::sin(3.0 * t + phase) + 0.5 * std::sin(7.0 * t + 2.0 * phase) +
                                                     0.25 * std::sin(17.0 * t + 3.0 * phase)));
        line.push_back(centre + Vec2{r * std::cos(t), r * std::sin(t)});
    }
    return line;
}

Scene disc(double triangles) {
    Scene scene{"disc", {}};
    const double h = std::sqrt(std::numbers::pi / (kTriangle * triangles));
    const int nodes = std::max(8, static_cast<int>(std::lround(2.0 * std::numbers::pi / h)));
    addLoop(scene.job.domain, coast({0, 0}, 1.0, nodes, 0.0, 0.0), 1);
    scene.job.spacing.size = h;
    return scene;
}

Scene square(double triangles) {
    Scene scene{"square", {}};
    addLoop(scene.job.domain, rectangle(1.0, 1.0), 1);
    scene.job.spacing.size = std::sqrt(1.0 / (kTriangle * triangles));
    return scene;
}

Scene graded(double r) {
    Scene scene{"graded", {}};
    addLoop(scene.job.domain, rectangle(60.0, 40.0), 1);
    scene.job.spacing.expression = "max(" + std::to_string(r) + ",0.232*abs(sqrt((x-30)^2+(y-20)^2)-12))";
    return scene;
}

/// ρ = s·10^(-4+4x) on [0,1]x[0,0.05]: ∫dA/(√3/4·ρ²) = 0.05·(10⁸-1)/(8·ln10·√3/4·s²).
Scene ramp(double triangles) {
    Scene scene{"ramp", {}};
    addLoop(scene.job.domain, rectangle(1.0, 0.05), 1);
    const double s = std::sqrt(0.05 * (1e8 - 1.0) / (8.0 * std::numbers::ln10 * kTriangle * triangles));
    scene.job.spacing.expression = std::to_string(s) + "*10^(4*x-4)";
    scene.job.spacing.gradation = 1e9; // steeper at its coarse end than spacing is by default
    return scene;
}

Scene islands(double triangles) {
    Scene scene{"islands", {}};
    addLoop(scene.job.domain, coast({0, 0}, 10.0, 1200, 0.02, 1.0), 1);
    for (int i = 0; i < 300; ++i) { // a sunflower of islands: never too near to each other
        const double radius = 8.6 * std::sqrt((i + 0.5) / 300.0);
        const double angle = 2.399963229728653 * i;
        const double size = 0.06 + 0.12 * ((i * 37) % 100) / 100.0;
        addLoop(scene.job.domain, coast({radius * std::cos(angle), radius * std::sin(angle)}, size, 40, 0.06, i), 2);
    }
    scene.job.spacing.fromBoundary = true;
    scene.job.spacing.size = std::sqrt(300.0 / (kTriangle * triangles));
    return scene;
}

/// Returns a number in [-1, 1] that depends on the arguments alone (SplitMix64 of S. Vigna).
double noiseAt(std::uint64_t seed, std::uint64_t octave, std::uint64_t bump) {
    std::uint64_t x = (seed * 64 + octave + 1) * 0x9e3779b97f4a7c15ULL + bump * 0xd1342543de82ef95ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1.0;
}

/// A circle whose radius varies in all octaves down to its segments, as that of a coast does; it never meets itself.
std::vector<Vec2> fractalCoast(Vec2 centre, double radius, int nodes, std::uint64_t seed) {
    constexpr double kAmplitude = 0.12, kRoughness = 0.55; // amplitude of the first octave; factor from one to the next
    constexpr int kFirstBumps = 5;
    std::vector<Vec2> line;
    for (int i = 0; i < nodes; ++i) {
        const double turn = static_cast<double>(i) / nodes;
        double height = 0.0, amplitude = kAmplitude;
        std::uint64_t bumps = kFirstBumps;
        for (std::uint64_t octave = 0; 2 * bumps < static_cast<std::uint64_t>(nodes); ++octave, bumps *= 2) {
            const double along = turn * static_cast<double>(bumps);
            const auto bump = static_cast<std::uint64_t>(along);
            const double from = noiseAt(seed, octave, bump), to = noiseAt(seed, octave, (bump + 1) % bumps);
            height += amplitude * (from + (along - static_cast<double>(bump)) * (to - from));
            amplitude *= kRoughness;
        }
        const double angle = 2.0 * std::numbers::pi * turn, r = radius * (1.0 + height);
        line.push_back(centre + Vec2{r * std::cos(angle), r * std::sin(angle)});
    }
    return line;
}

Scene coastline(double segments) {
    constexpr int kIslands = 40;
    constexpr double kShare = 0.6; ///< of the segments on the outer coast
    Scene scene{"coast", {}};
    addLoop(scene.job.domain, fractalCoast({0, 0}, 10.0, static_cast<int>(kShare * segments), 1), 1);
    const int each = std::max(8, static_cast<int>((1.0 - kShare) * segments / kIslands));
    for (int i = 0; i < kIslands; ++i) {
        const double radius = 5.6 * std::sqrt((i + 0.5) / kIslands);
        const double angle = 2.399963229728653 * i;
        addLoop(scene.job.domain,
                fractalCoast({radius * std::cos(angle), radius * std::sin(angle)}, 0.15 + 0.01 * (i * 7 % 17), each,
                             static_cast<std::uint64_t>(i) + 2),
                2);
    }
    return scene;
}

} // namespace

std::optional<Scene> makeScene(std::string_view name, double size) {
    if (name == "disc") {
        return disc(size);
    }
    if (name == "graded") {
        return graded(size);
    }
    if (name == "ramp") {
        return ramp(size);
    }
    if (name == "islands") {
        return islands(size);
    }
    if (name == "coast") {
        return coastline(size);
    }
    if (name == "square") {
        return square(size);
    }
    return std::nullopt;
}

} // namespace forefront::bench
