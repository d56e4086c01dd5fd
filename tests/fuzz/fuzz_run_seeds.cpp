#include "core/files/text/base64.hpp"
#include "tests/fuzz/fuzz_runs.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

namespace forefront::fuzz {

namespace {

/// Returns a project of a rectangle with a hole and a line inside, with further members of the project.
std::string projectWith(const std::string &options, const std::string &members) {
    return R"({"format": "forefront", "version": 1, "shapes": [)"
           R"({"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "nodes": [[0, 0], [8, 0], [8, 4], [0, 4]], )"
           R"("segmentTags": [1, 2, 3, 4]}, )"
           R"({"id": 2, "kind": "circle", "use": "boundary", "tag": 5, "nodes": [[2, 2], [2.5, 2]]}, )"
           R"({"id": 3, "kind": "polyline", "use": "constraint", "tag": 6, "nodes": [[4, 0], [4, 4]]}, )"
           R"({"id": 4, "kind": "polyline", "use": "constraint", "tag": 7, "nodes": [[2.2, 3], [3, 3.5], [3.5, 3]]}], )"
           R"("regionMarkers": [{"at": [0.2, 0.2], "tag": 1}, {"at": [7, 2], "tag": 2, "maxArea": 0.3}], )"
           R"("spacing": {"size": 0.5}, "options": {)" +
           options + "}" + members + R"(, "nextId": 5})";
}

/// Inputs for runMesh() that broke a promise once, in base64: layers on lines that cross.
constexpr const char *kFound[] = {
    "AgQOIAUAAfkFNDE4ODY1ODI5NBb0IANXjMCzl+wMxQiYOvKr3NgHgXbOLTyis+D84KXGRGgcbY8aBAeMrMxh9aDDDLl0UPn0NDcw"
    "NDQ1MDc0OsE="};

/// Returns bytes that follow from a seed, with the first ones given.
std::string bytesFrom(std::uint32_t seed, std::string first) {
    constexpr std::size_t kBytes = 64;
    std::mt19937 random(seed);
    while (first.size() < kBytes) {
        first += static_cast<char>(random() % 256);
    }
    return first;
}

} // namespace

std::vector<std::string> meshSeeds() {
    // The first bytes: elements and order, least angle, sizes; then parts: layers, periodic and cracks, and the others.
    constexpr std::pair<unsigned char, unsigned char> kParts[] = {
        {0, 0}, {1, 0}, {13, 0}, {5, 0}, {8, 0}, {40, 0}, {64, 0}, {65, 0}, {0, 1}, {0, 9}, {72, 65}, {105, 73}};
    std::vector<std::string> list;
    unsigned seed = 1;
    for (const unsigned kinds : {0, 1, 2, 4, 5, 13, 70}) {
        for (const auto &[parts, more] : kParts) {
            std::string first;
            for (const unsigned byte : {kinds, seed % 8, 14U, 32U, unsigned{parts}, unsigned{more}}) {
                first += static_cast<char>(byte);
            }
            list.push_back(bytesFrom(seed++, first));
        }
    }
    for (const char *const found : kFound) {
        list.push_back(fromBase64(found).value_or(""));
    }
    return list;
}

std::vector<std::string> projectSeeds() {
    const std::string quads = R"("elements": "quads")", curved = R"("elements": "quads", "order": 2, "quadNodes": 9)";
    return {projectWith("", ""),
            projectWith(quads, ""),
            projectWith(curved, ""),
            projectWith(R"("elements": "mixed", "order": 2)", ""),
            projectWith(quads, R"(, "layers": [{"tag": 5, "first": 0.02, "growth": 1.2, "count": 4}])"),
            projectWith(curved, R"(, "layers": [{"tag": 1, "first": 0.05, "thickness": 0.3, "type": "triangles"}])"),
            projectWith(quads, R"(, "periodic": [{"from": 1, "to": 3}, {"from": 4, "to": 2}])"),
            projectWith(curved, R"(, "cracks": [7])"),
            projectWith(quads, R"(, "mapped": [{"region": 2}])"),
            projectWith(R"("order": 2)", R"(, "mapped": [{"region": 2, "corners": [[4, 0], [8, 0], [8, 4], [4, 4]]}])"),
            projectWith(quads, R"(, "strips": [{"tag": 7, "width": 0.1, "rows": 2, "type": "quads"}])"),
            projectWith("", R"(, "regionElements": [{"region": 2, "elements": "quads"}])")};
}

} // namespace forefront::fuzz
