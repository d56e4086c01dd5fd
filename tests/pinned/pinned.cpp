// Meshes of fixed scenes, compared with the hashes in a table: a change that alters meshes has to say so.
//   forefront_pinned ASSETS TABLE [--update]
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/bench/scenes.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace forefront;

namespace {

/// Scenes of the benchmarks with sizes that give a few thousand elements.
const std::vector<std::pair<std::string, double>> kScenes = {{"square", 2000.0}, {"disc", 2000.0},  {"graded", 0.5},
                                                             {"ramp", 2000.0},   {"islands", 40.0}, {"coast", 2000.0}};

std::vector<bench::Scene> benchScenes() {
    std::vector<bench::Scene> scenes;
    for (const auto &[name, size] : kScenes) {
        bench::Scene scene = bench::makeScene(name, size).value();
        std::ostringstream label;
        label << name << '-' << size;
        scene.name = label.str();
        scenes.push_back(std::move(scene));
    }
    // Given segments that stay undivided are a way of their own through the boundary.
    bench::Scene kept = bench::makeScene("coast", 500.0).value();
    kept.name = "coast-500-kept";
    kept.job.options.keepBoundary = true;
    scenes.push_back(std::move(kept));
    return scenes;
}

/// Returns the projects of a folder as scenes, in the order of their names. Exits if one cannot be read.
std::vector<bench::Scene> projects(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".json") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<bench::Scene> scenes;
    for (const std::filesystem::path &file : files) {
        const Result<Document> document = readDocument(file);
        if (!document) {
            std::fprintf(stderr, "%s\n", toString(document.faults().front()).c_str());
            std::exit(2);
        }
        scenes.push_back({file.stem().string(), jobOf(*document)});
    }
    return scenes;
}

/// Returns a line of the table: hash and number of elements.
std::string pinned(MeshingJob job, Method method, ImproveLevel level) {
    job.options.method = method;
    job.options.improve = level;
    job.options.threads = 1;
    const Result<MeshingOutcome> outcome = meshDomain(job);
    if (!outcome) {
        return "refused: " + outcome.faults().front().code;
    }
    return toHex(meshHash(outcome->mesh)) + ' ' + std::to_string(outcome->mesh.triangles().size());
}

std::vector<std::string> makeTable(const std::filesystem::path &assets) {
    std::vector<bench::Scene> scenes = benchScenes();
    for (const char *folder : {"samples", "lessons/drawings"}) {
        std::vector<bench::Scene> more = projects(assets / folder);
        std::move(more.begin(), more.end(), std::back_inserter(scenes));
    }
    std::vector<std::string> lines;
    for (const bench::Scene &scene : scenes) {
        for (const Method method : {Method::Classic, Method::Fast}) {
            for (const ImproveLevel level : {ImproveLevel::None, ImproveLevel::Default, ImproveLevel::Best}) {
                lines.push_back(scene.name + ' ' + std::string(wordOf(method)) + ' ' + std::string(wordOf(level)) +
                                ' ' + pinned(scene.job, method, level));
            }
        }
    }
    return lines;
}

std::vector<std::string> readTable(const char *path) {
    std::vector<std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// Prints the lines that differ and returns their number.
int printDifferences(const std::vector<std::string> &pinnedLines, const std::vector<std::string> &made) {
    int differences = 0;
    for (std::size_t k = 0; k < std::max(pinnedLines.size(), made.size()); ++k) {
        const std::string was = k < pinnedLines.size() ? pinnedLines[k] : "(none)";
        const std::string now = k < made.size() ? made[k] : "(none)";
        if (was != now) {
            std::printf("- %s\n+ %s\n", was.c_str(), now.c_str());
            ++differences;
        }
    }
    return differences;
}

} // namespace

int main(int argc, char **argv) {
    const bool update = argc == 4 && std::string_view(argv[3]) == "--update";
    if (argc != 3 && !update) {
        std::fprintf(stderr, "usage: forefront_pinned ASSETS TABLE [--update]\n");
        return 2;
    }
    const std::vector<std::string> made = makeTable(argv[1]);
    const int differences = printDifferences(readTable(argv[2]), made);
    if (update) {
        std::ofstream file(argv[2]);
        for (const std::string &line : made) {
            file << line << '\n';
        }
        return file.good() ? 0 : 2;
    }
    if (differences > 0) {
        std::printf("%d of %zu meshes differ; if that is meant, run with --update and say why in the commit\n",
                    differences, made.size());
    }
    return differences > 0 ? 1 : 0;
}
