#include "tests/fuzz/fuzz_runs.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/fuzz/byte_numbers.hpp"
#include "tests/fuzz/fuzz_checks.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <span>

namespace forefront::fuzz {

namespace {

constexpr std::uint64_t kMaxFuzzElements = 4000;

/// The tags of the parts of a domain that is read from bytes.
enum FuzzTag : std::int32_t { kBottom = 1, kRight, kTop, kLeft, kFirstLine, kSecondLine, kHole, kHoleRight, kDivider };

/// Builds a domain from numbers: an outline with four sides, lines inside, and a hole with straight or curved edges.
class FuzzDomain {
  public:
    explicit FuzzDomain(ByteNumbers &numbers) : numbers_(numbers) {}

    Domain build() {
        const unsigned shape = numbers_.byte();
        addOutline(shape);
        for (unsigned lines = shape / 4 % 4; lines > 0; --lines) {
            addLine(lines % 2 == 1 ? kFirstLine : kSecondLine);
        }
        if (shape / 16 % 4 != 0) {
            addHole(shape / 16 % 4);
        }
        for (unsigned points = shape / 64; points > 0; --points) {
            domain_.points.push_back({node(place()), 1});
        }
        domain_.boundaryNames = {{kFirstLine, "line"}, {kHole, "hole"}};
        if (shape % 4 < 2 && numbers_.byte() % 4 != 0) { // else places may be outside
            domain_.segments.push_back({node({6, 0}), node({6, 4}), kDivider, SegmentRole::Constraint});
            domain_.regionMarkers = {{{0.01, 0.01}, 1}, {{7.99, 3.99}, 2}};
        }
        return std::move(domain_);
    }

  private:
    std::uint32_t node(Vec2 at) {
        domain_.nodes.push_back(at);
        return static_cast<std::uint32_t>(domain_.nodes.size() - 1);
    }
    Vec2 place() {
        const double x = 0.25 * numbers_.coordinate();
        return {x, 0.125 * numbers_.coordinate()};
    }

    /// A rectangle, or one with corners or nodes of its sides moved.
    void addOutline(unsigned shape) {
        constexpr double kWidth = 8.0, kHeight = 4.0;
        std::array<Vec2, 4> corners = {Vec2{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}};
        if (shape % 4 >= 2) {
            corners[numbers_.byte() % 4] = place();
        }
        std::array<std::uint32_t, 4> nodes{};
        for (std::size_t k = 0; k < 4; ++k) {
            nodes[k] = node(corners[k]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            std::uint32_t last = nodes[k];
            const std::int32_t tag = kBottom + static_cast<std::int32_t>(k);
            if (shape % 2 == 1) {
                const std::uint32_t between =
                    node(numbers_.byte() % 4 == 0 ? place() : midpoint(corners[k], corners[(k + 1) % 4]));
                domain_.segments.push_back({last, between, tag});
                last = between;
            }
            domain_.segments.push_back({last, nodes[(k + 1) % 4], tag});
        }
    }

    void addLine(std::int32_t tag) {
        std::uint32_t last = node(place());
        for (unsigned parts = 1 + numbers_.byte() % 3; parts > 0; --parts) {
            const std::uint32_t next = node(place());
            domain_.segments.push_back({last, next, tag, SegmentRole::Constraint});
            last = next;
        }
    }

    /// kind 1: a triangle; 2: an ellipse; 3: a circle of two tags.
    void addHole(unsigned kind) {
        const Vec2 centre = place();
        const double radius = 0.05 + numbers_.byte() / 256.0, height = kind == 2 ? 0.3 * radius : radius;
        const unsigned chords = kind == 1 ? 3 : 24;
        std::vector<std::uint32_t> nodes;
        for (unsigned k = 0; k < chords; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / chords;
            nodes.push_back(node(centre + Vec2{radius * std::cos(angle), height * std::sin(angle)}));
        }
        if (kind != 1) {
            domain_.curves.push_back(Curve::arc(centre, {radius, 0.0}, {0.0, height}));
        }
        for (unsigned k = 0; k < chords; ++k) {
            DomainSegment segment{nodes[k], nodes[(k + 1) % chords], kind == 3 && k < chords / 2 ? kHoleRight : kHole};
            if (kind != 1) {
                segment.stretch = {0, static_cast<double>(k) / chords, static_cast<double>(k + 1) / chords};
            }
            domain_.segments.push_back(segment);
        }
    }

    ByteNumbers &numbers_;
    Domain domain_;
};

void readOptions(ByteNumbers &numbers, MeshingOptions &options) {
    const unsigned kinds = numbers.byte();
    options.elements = static_cast<Elements>(kinds % 3);
    options.order = kinds / 4 % 2 == 1 ? ElementOrder::Second : ElementOrder::First;
    options.quadNodes = kinds / 8 % 2 == 1 ? QuadNodes::Nine : QuadNodes::Eight;
    options.method = kinds / 16 % 4 == 3 ? Method::Classic : Method::Fast;
    options.improve = static_cast<ImproveLevel>(kinds / 64 % 3);
    options.keepBoundary = kinds / 128 == 1 && kinds % 8 == 0;
    options.maxElements = kMaxFuzzElements;
    options.verify = true;
    if (const unsigned angle = numbers.byte(); angle % 4 == 0 && (kinds % 3 == 0 || angle % 16 == 0)) {
        options.leastAngle = angle / 4 % 34;
    }
}

void readSizes(ByteNumbers &numbers, SpacingSpec &spacing) {
    const unsigned kinds = numbers.byte();
    if (kinds % 2 == 0) {
        spacing.size = 0.125 + numbers.byte() / 128.0;
    }
    if (kinds / 2 % 4 == 0) {
        spacing.placed.regions = {{.at = {0.3, 0.3}, .maxArea = 0.01 + numbers.byte() / 256.0}};
    }
    if (kinds / 8 % 4 == 0) {
        spacing.partSizes[kHole] = {.size = 0.03 + numbers.byte() / 256.0};
    }
}

LayerSpec layersOn(std::int32_t tag, ByteNumbers &numbers) {
    LayerSpec layers{.tag = tag, .first = std::ldexp(1.0, -static_cast<int>(numbers.byte() % 12) - 1)};
    const unsigned kinds = numbers.byte();
    layers.growth = 1.0 + 0.125 * (kinds % 9);
    if (kinds / 16 % 3 == 1) {
        layers.count = 1 + numbers.byte() % 24;
    } else if (kinds / 16 % 3 == 2) {
        layers.thickness = 0.03 * (1 + numbers.byte());
    }
    layers.cells = kinds / 64 % 2 == 1 ? LayerCells::Triangles : LayerCells::Quads;
    return layers;
}

/// Reads the layers, strips and other parts of a job, with the nodes that are corners of mapped regions. What does not
/// fit the domain is to be refused.
std::vector<unsigned> readParts(ByteNumbers &numbers, MeshingJob &job) {
    std::vector<unsigned> corners;
    const unsigned kinds = numbers.byte(), more = numbers.byte();
    if (kinds % 4 == 1) {
        job.layers.push_back(layersOn(1 + static_cast<std::int32_t>(numbers.byte() % 8), numbers));
        if (kinds / 4 % 2 == 1) {
            job.layers.push_back(layersOn(1 + static_cast<std::int32_t>(numbers.byte() % 8), numbers));
        }
    }
    if (kinds / 8 % 4 == 1) {
        job.periodic.push_back({kLeft, kRight});
        if (kinds / 32 % 2 == 1) {
            job.periodic.push_back({kBottom, kTop});
        }
    }
    if (kinds / 64 == 1) {
        job.cracks.push_back(kFirstLine);
    }
    if (more % 4 == 1) {
        StripSpec strip{.tag = kSecondLine, .width = 0.01 + numbers.byte() / 256.0, .rows = 1 + numbers.byte() % 4};
        strip.cells = more / 4 % 2 == 1 ? LayerCells::Triangles : LayerCells::Quads;
        job.strips.push_back(strip);
    }
    if (more / 8 % 4 == 1) {
        job.mapped.push_back({.region = 1 + static_cast<std::int32_t>(more / 32 % 2)});
        for (unsigned count = numbers.byte() % 5; count > 0; --count) {
            corners.push_back(numbers.byte());
        }
    }
    if (more / 64 == 1) {
        const auto region = static_cast<std::int32_t>(1 + numbers.byte() % 3);
        job.regionElements.push_back({region, static_cast<Elements>(numbers.byte() % 3)});
    }
    return corners;
}

/// Returns true if a fault is that of a quadrilateral which is not convex.
bool isOfShape(const Diagnostic &fault) {
    return fault.code == "concave-element" || fault.code == "inverted-element";
}

/// Returns true if a run has named the corner of an element that is not convex.
bool isReported(const PlacedCell &cell, const QuadReport &report) {
    return std::ranges::any_of(cell.corners(), [&](Vec2 corner) {
        return std::ranges::find(report.notConvexAt, corner) != report.notConvexAt.end();
    });
}

/// Checks that the only elements which are not positive are those that the run has named.
void checkPositive(const MeshingOutcome &outcome) {
    const MeshView mesh(outcome.mesh);
    for (const Diagnostic &fault : verify(mesh)) {
        if (fault.severity != Severity::Error) {
            continue;
        }
        const bool isShape = isOfShape(fault) || fault.code == "folded-element";
        const bool named =
            isShape && fault.ids.size() == 1 && isReported(PlacedCell(mesh, fault.ids[0]), outcome.quads);
        if (!named) {
            std::fprintf(stderr, "%s\n", toString(fault).c_str());
        }
        demand(named, "an element is positive, or the run names it");
    }
}

/// Meshes a job. Ends the program if that takes more than a minute.
Result<MeshingOutcome> meshedInTime(const MeshingJob &job) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto checkTime = [start] {
        demand(Clock::now() - start < std::chrono::seconds(60), "a run ends within a minute");
    };
    Result<MeshingOutcome> outcome = meshDomain(job, {[&](std::string_view, double) { checkTime(); }, {}});
    checkTime();
    return outcome;
}

/// Returns true if a fault says that a finished mesh is wrong.
bool isWrongMesh(const Diagnostic &fault) {
    return fault.message.find("the finished mesh is wrong") != std::string::npos;
}

void checkRun(MeshingJob job) {
    Result<MeshingOutcome> outcome = meshedInTime(job);
    if (!outcome && std::ranges::any_of(outcome.faults(), isWrongMesh)) {
        for (const Diagnostic &fault : outcome.faults()) {
            if (fault.severity == Severity::Error && !isOfShape(fault)) {
                std::fprintf(stderr, "%s\n", toString(fault).c_str());
                demand(false, "a finished mesh is right");
            }
        }
        job.options.verify = false; // the elements that are not convex must be in the report
        outcome = meshedInTime(job);
    }
    if (!outcome) {
        demand(!outcome.faults().empty(), "a refusal says why");
        for (const Diagnostic &fault : outcome.faults()) {
            demand(!fault.message.empty() && !fault.code.empty(), "a fault has a message and a code");
            toString(fault);
        }
        return;
    }
    checkMesh(outcome->mesh);
    checkPositive(*outcome);
}

} // namespace

void runMesh(std::string_view bytes) {
    ByteNumbers numbers(bytes);
    MeshingJob job;
    readOptions(numbers, job.options);
    readSizes(numbers, job.spacing);
    const std::vector<unsigned> corners = readParts(numbers, job);
    Result<Repaired> repaired = repair(FuzzDomain(numbers).build());
    if (!repaired) {
        return; // the target "repair" has its promises
    }
    job.domain = std::move(repaired->domain);
    for (const unsigned corner : corners) {
        if (!job.domain.nodes.empty()) {
            job.mapped.front().corners.push_back(job.domain.nodes[corner % job.domain.nodes.size()]);
        }
    }
    checkRun(job);
}

void runProject(std::string_view bytes) {
    const Result<Document> document = parseProject(bytes, "fuzz");
    if (!document) {
        return; // the target "project" has its promises
    }
    MeshingJob job = jobOf(*document);
    job.options.maxElements = std::min(job.options.maxElements, kMaxFuzzElements);
    job.options.threads = 1;
    job.options.verify = true;
    checkRun(job);
}

} // namespace forefront::fuzz
