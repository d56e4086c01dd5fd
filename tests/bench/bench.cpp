// Benchmark of the standard cases. One process per case, so that each has its own memory peak; CSV on stdout.
//   forefront_bench [--classic] [--grid none|uniform|hierarchical] [--improve none|default|best] [--threads N]
//                   [--repeat N] [SCENE SIZE]...
#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/bench/scenes.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace forefront;

namespace {

struct BenchSettings {
    GridKind grid = GridKind::Hierarchical;
    Method method = Method::Fast;
    ImproveLevel improve = ImproveLevel::Default;
    unsigned threads = 1;
    int repeat = 1;
    std::vector<std::pair<std::string, double>> cases;
};

double residentBytes() {
    std::ifstream statm("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    statm >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double peakBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

int runCase(const std::string &name, double size, const BenchSettings &settings) {
    std::optional<bench::Scene> made = bench::makeScene(name, size);
    if (!made) {
        std::fprintf(stderr, "no scene %s: square, disc, graded, ramp, islands, coast\n", name.c_str());
        return 1;
    }
    bench::Scene &scene = *made;
    scene.job.options.grid = settings.grid;
    scene.job.options.improve = settings.improve;
    scene.job.options.threads = settings.threads;
    scene.job.options.method = settings.method;
    const double before = residentBytes();
    const Result<MeshingOutcome> outcome = meshDomain(scene.job);
    if (!outcome) {
        std::fprintf(stderr, "%s %g: %s\n", name.c_str(), size, toString(outcome.faults().front()).c_str());
        return 1;
    }
    const double peak = peakBytes() - before;
    const MeshQuality quality = measureQuality(outcome->mesh, outcome->spacing.get());
    const auto elements = static_cast<double>(quality.elements);
    const WorkCounters &work = outcome->work;
    std::printf("%s,%g,%s,%s,%s,%u,%zu,%.4f,%.4f,%.4f,%.4f,%.0f,%.0f,%.1f,%.5f,%.4f,%.2f,%.4f,%.0f,%.3f,%.4f,%.3f,%.4f,"
                "%llu,%s\n",
                name.c_str(), size, wordOf(settings.method).data(), wordOf(settings.grid).data(),
                wordOf(settings.improve).data(), settings.threads, quality.elements, outcome->secondsPrepare,
                outcome->secondsMesh, outcome->secondsImprove, outcome->secondsWall, elements / outcome->secondsMesh,
                elements / (outcome->secondsMesh + outcome->secondsImprove), peak / elements, quality.alphaMean,
                quality.alphaMin, quality.minAngle, quality.deltaMean, work.frontMean(), work.neighboursMean(),
                work.testsMean(), static_cast<double>(work.cellsVisited) / elements,
                static_cast<double>(work.candidates) / elements, static_cast<unsigned long long>(work.forced),
                toHex(meshHash(outcome->mesh)).c_str());
    return 0;
}

bool parse(int argc, char **argv, BenchSettings &settings) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--classic") {
            settings.method = Method::Classic;
        } else if (word == "--no-improve") {
            settings.improve = ImproveLevel::None;
        } else if (word == "--improve" && i + 1 < argc) {
            const auto level = fromWord<ImproveLevel>(argv[++i]);
            if (!level) {
                return false;
            }
            settings.improve = *level;
        } else if (word == "--threads" && i + 1 < argc) {
            settings.threads = static_cast<unsigned>(std::max(1, std::atoi(argv[++i])));
        } else if (word == "--grid" && i + 1 < argc) {
            const auto grid = fromWord<GridKind>(argv[++i]);
            if (!grid) {
                return false;
            }
            settings.grid = *grid;
        } else if (word == "--repeat" && i + 1 < argc) {
            settings.repeat = std::max(1, std::atoi(argv[++i]));
        } else if (i + 1 < argc && std::atof(argv[i + 1]) > 0.0) {
            settings.cases.emplace_back(word, std::atof(argv[++i]));
        } else {
            return false;
        }
    }
    if (settings.cases.empty()) {
        settings.cases = {{"square", 1e4},  {"square", 1e5}, {"square", 1e6},  {"disc", 1e4},     {"disc", 1e5},
                          {"disc", 1e6},    {"graded", 0.1}, {"graded", 0.02}, {"graded", 0.005}, {"ramp", 1e5},
                          {"islands", 1e5}, {"coast", 1e4},  {"coast", 1e5}};
    }
    return true;
}

} // namespace

int main(int argc, char **argv) {
    keepFreedMemory();
    BenchSettings settings;
    if (!parse(argc, argv, settings)) {
        std::fprintf(stderr,
                     "usage: forefront_bench [--classic] [--grid KIND] [--improve LEVEL] [--threads N] [--repeat N] "
                     "[SCENE SIZE]...\n"
                     "KIND: %s; LEVEL: %s\n",
                     wordList<GridKind>().c_str(), wordList<ImproveLevel>().c_str());
        return 2;
    }
    std::printf("scene,size,method,grid,improve,threads,triangles,seconds_prepare,seconds_mesh,seconds_improve,seconds_"
                "wall,triangles_"
                "per_second_raw,"
                "triangles_per_second,"
                "peak_bytes_per_triangle,alpha_mean,alpha_min,min_angle_deg,delta_mean,Nb,Nc,Ns,cells_per_triangle,"
                "candidates_per_triangle,forced,hash\n");
    int failures = 0;
    for (const auto &[name, size] : settings.cases) {
        for (int round = 0; round < settings.repeat; ++round) {
            std::fflush(stdout);
            const pid_t child = fork();
            if (child == 0) {
                const int code = runCase(name, size, settings);
                std::fflush(stdout);
                _exit(code);
            }
            int status = 0;
            if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
                ++failures;
            }
        }
    }
    return failures == 0 ? 0 : 1;
}
