#include "tests/unit/io_samples.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <unistd.h>

namespace forefront::testing {

ScratchFolder::ScratchFolder() {
    static std::atomic<int> number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("forefront-io-" + std::to_string(::getpid()) + '-' + std::to_string(number++));
    std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

namespace {

Shape shape(std::uint32_t id, ShapeKind kind, ShapeUse use, std::vector<Vec2> nodes, std::string name) {
    Shape result;
    result.id = id;
    result.kind = kind;
    result.use = use;
    result.nodes = std::move(nodes);
    result.tag = static_cast<std::int32_t>(id);
    result.name = std::move(name);
    return result;
}

PaintedSpacing paintedPatch() {
    PaintedSpacing paint;
    paint.origin = {-0.1, 1e-17};
    paint.pitch = 0.3;
    for (const int tileNumber : {-1, 0, 70000}) {
        PaintedSpacing::Tile tile{};
        for (std::size_t k = 0; k < tile.size(); ++k) {
            tile[k] = k % 5 == 0 ? 0.0F : 0.1F + 0.01F * static_cast<float>(std::sin(static_cast<double>(k / 3)) + 1.0);
        }
        paint.tiles.emplace(std::pair(tileNumber, -tileNumber), std::make_shared<const PaintedSpacing::Tile>(tile));
    }
    paint.tiles.emplace(std::pair(5, 5), std::make_shared<const PaintedSpacing::Tile>());
    return paint;
}

} // namespace

Document fullDocument() {
    Document document;
    Shape outline = shape(1, ShapeKind::Polygon, ShapeUse::Boundary, {{0, 0}, {4, 0}, {4, 3.1}, {1.0 / 3.0, 3}},
                          "quay \"north\" \\ Ä\n");
    outline.segmentTags = {1, 2, 2, 7};
    Shape pier = shape(4, ShapeKind::Polyline, ShapeUse::Constraint, {{1, 1}, {1.5, 1}, {2, 1.25}}, "pier");
    for (const Shape &item : {outline, shape(2, ShapeKind::Rectangle, ShapeUse::Boundary, {{3, 1}, {3.5, 2}}, ""),
                              shape(3, ShapeKind::Circle, ShapeUse::Boundary, {{1, 2}, {1.2, 2}}, "island"), pier,
                              shape(9, ShapeKind::Point, ShapeUse::Constraint, {{2.5, 0.5}}, "gauge")}) {
        document.shapes.push_back(std::make_shared<const Shape>(item));
    }
    document.regionMarkers = {{{0.5, 0.5}, 3}, {{-1e-300, 1e300}, 1}};
    document.boundaryNames = {{1, "wall"}, {7, "inlet"}};
    document.regionNames = {{3, "water"}};
    document.spacing.size = 0.1;
    document.spacing.expression = "max(0.1, \"x\"*x)";
    document.spacing.sources = {{SourceShape::Point, {1, 2}, {}, 0.0, 0.05, 0.3, "head"},
                                {SourceShape::Line, {1, 2}, {3, 4}, 0.5, 0.05, 0.0, ""},
                                {SourceShape::Circle, {1, 2}, {}, 0.25, 0.01, 0.2, "disc"}};
    document.spacing.paint = paintedPatch();
    document.spacing.background = std::make_shared<const BackgroundMesh>(
        BackgroundMesh{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {2, 1, 3}}, {0.1, 0.2, 0.3, 0.4}});
    document.spacing.fromBoundary = true;
    document.spacing.minimum = 1e-3;
    document.spacing.maximum = 12.5;
    document.spacing.gradation = 0.3;
    document.options.grid = GridKind::Uniform;
    document.options.gridColumns = 12;
    document.options.gridRows = 7;
    document.options.keepBoundary = true;
    document.options.improve = false;
    document.options.threads = 3;
    document.circleTolerance = 0.01;
    document.nextId = 12;
    return document;
}

std::string messages(const Diagnostics &faults) {
    std::string text;
    for (const Diagnostic &fault : faults) {
        text += toString(fault) + '\n';
    }
    return text;
}

bool hasCode(const Diagnostics &faults, std::string_view code) {
    return std::any_of(faults.begin(), faults.end(), [&](const Diagnostic &fault) { return fault.code == code; });
}

bool allLocated(const Diagnostics &faults) {
    return std::all_of(faults.begin(), faults.end(), [](const Diagnostic &fault) {
        return !fault.file.empty() && fault.line > 0 && fault.column > 0;
    });
}

} // namespace forefront::testing
