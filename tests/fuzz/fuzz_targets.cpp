#include "tests/fuzz/fuzz_targets.hpp"

#include "core/arrangement/repair.hpp"
#include "core/domain/validate.hpp"
#include "core/io/abaqus/abaqus.hpp"
#include "core/io/geojson/geojson.hpp"
#include "core/io/gmsh/gmsh.hpp"
#include "core/io/medit/medit.hpp"
#include "core/io/obj/obj.hpp"
#include "core/io/project/project.hpp"
#include "core/io/su2/su2.hpp"
#include "core/io/svg/svg.hpp"
#include "core/io/triangle/triangle.hpp"
#include "core/io/vtk/vtk.hpp"
#include "core/mesh/mesh_domain.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace forefront::fuzz {

namespace {

void demand(bool kept, const char *promise) {
    if (!kept) {
        std::fprintf(stderr, "broken promise: %s\n", promise);
        std::abort();
    }
}

SourceText sourceOf(std::string_view bytes) {
    return {bytes, "fuzz", {}, {}};
}

void checkFaults(const Diagnostics &faults) {
    demand(!faults.empty(), "a refusal says why");
    for (const Diagnostic &fault : faults) {
        demand(!fault.file.empty() && fault.line > 0 && fault.column > 0, "a fault has file, line and column");
        demand(!fault.message.empty() && !fault.code.empty(), "a fault has a message and a code");
        toString(fault);
    }
}

void checkNotes(const ImportNotes &notes) {
    for (const ImportNote &note : notes.entries()) {
        demand(note.count > 0 && note.line > 0 && note.column > 0, "a note has a count, line and column");
        demand(!note.message.empty() && !note.code.empty(), "a note has a message and a code");
    }
}

void checkMesh(const Mesh &mesh) {
    const auto known = [&](NodeId node) { return index(node) < mesh.nodes.size(); };
    demand(std::all_of(mesh.nodes.begin(), mesh.nodes.end(), isFinite), "coordinates are finite");
    demand(mesh.regions.empty() || mesh.regions.size() == mesh.elements.size(), "a region for every element");
    for (const Element &element : mesh.elements) {
        demand(std::all_of(element.begin(), element.end(), known), "elements use nodes that exist");
        demand(element[0] != element[1] && element[1] != element[2] && element[2] != element[0],
               "elements have three different nodes");
    }
    for (const TaggedEdge &edge : mesh.edges) {
        demand(known(edge.a) && known(edge.b) && edge.tag >= 1, "edges use nodes that exist and have a tag");
    }
    for (const TaggedNode &point : mesh.points) {
        demand(known(point.node) && point.tag >= 1, "points are nodes that exist and have a tag");
    }
}

void checkDomain(const Domain &domain) {
    const auto known = [&](std::uint32_t node) { return node < domain.nodes.size(); };
    demand(std::all_of(domain.nodes.begin(), domain.nodes.end(), isFinite), "coordinates are finite");
    for (const DomainSegment &segment : domain.segments) {
        demand(known(segment.a) && known(segment.b) && segment.tag >= 1, "segments use nodes that exist");
    }
    for (const ConstraintPoint &point : domain.points) {
        demand(known(point.node) && point.tag >= 1, "points are nodes that exist");
    }
}

template <Result<Mesh> (*read)(const SourceText &)>
void mesh(std::string_view bytes) {
    ImportNotes notes;
    SourceText source = sourceOf(bytes);
    source.notes = &notes;
    const auto result = read(source);
    checkNotes(notes);
    if (!result) {
        checkFaults(result.faults());
        return;
    }
    checkMesh(*result);
    if (const auto domain = domainOfMesh(*result)) {
        checkDomain(*domain);
    }
}

template <Result<Domain> (*read)(const SourceText &)>
void domain(std::string_view bytes) {
    ImportNotes notes;
    SourceText source = sourceOf(bytes);
    source.notes = &notes;
    const auto result = read(source);
    checkNotes(notes);
    if (result) {
        checkDomain(*result);
    } else {
        checkFaults(result.faults());
    }
}

void project(std::string_view bytes) {
    const auto result = readProjectText(sourceOf(bytes));
    if (!result) {
        checkFaults(result.faults());
        return;
    }
    const std::string text = projectText(*result);
    const auto again = parseProject(text, "again");
    demand(again.ok() && projectText(*again) == text, "a project survives being written and read");
}

/// Nodes, elements and edges in one input, separated by lines "%%".
void triangle(std::string_view bytes) {
    constexpr std::string_view kCut = "%%\n";
    const std::size_t first = std::min(bytes.find(kCut), bytes.size());
    const std::string_view rest = bytes.substr(std::min(first + kCut.size(), bytes.size()));
    const std::size_t second = std::min(rest.find(kCut), rest.size());
    const SourceText edges = sourceOf(rest.substr(std::min(second + kCut.size(), rest.size())));
    const auto result = readTriangleParts(sourceOf(bytes.substr(0, first)), sourceOf(rest.substr(0, second)),
                                          edges.text.empty() ? nullptr : &edges);
    if (result) {
        checkMesh(*result);
    } else {
        checkFaults(result.faults());
    }
}

void msh(std::string_view bytes) {
    mesh<readMsh>(bytes);
    if (const auto spacing = readMshSpacing(sourceOf(bytes)); !spacing) {
        checkFaults(spacing.faults());
    }
}

/// Reads numbers from bytes, 0 at the end of them.
class ByteNumbers {
  public:
    explicit ByteNumbers(std::string_view bytes) : bytes_(bytes) {}

    bool atEnd() const { return at_ >= bytes_.size(); }
    unsigned byte() { return atEnd() ? 0U : static_cast<unsigned char>(bytes_[at_++]); }
    /// A multiple of 1/8 in [0, 32), a few with a last digit off.
    double coordinate() {
        const double value = 0.125 * byte();
        return byte() % 16 == 0 ? value * (1.0 + std::numeric_limits<double>::epsilon()) : value;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

Domain domainFrom(ByteNumbers &numbers) {
    Domain domain;
    domain.insideRule = numbers.byte() % 2 == 0 ? InsideRule::EvenOdd : InsideRule::HoleMarkers;
    const unsigned nodes = 1 + numbers.byte() % 64;
    for (unsigned n = 0; n < nodes; ++n) {
        const double x = numbers.coordinate();
        domain.nodes.push_back({x, numbers.coordinate()});
    }
    while (!numbers.atEnd()) {
        const unsigned kind = numbers.byte(), a = numbers.byte() % nodes, b = numbers.byte() % nodes;
        if (kind % 8 == 7) {
            domain.points.push_back({a, 1});
        } else {
            const SegmentRole role = kind % 8 < 5 ? SegmentRole::Boundary : SegmentRole::Constraint;
            domain.segments.push_back({a, b, static_cast<std::int32_t>(1 + kind / 8), role});
        }
    }
    return domain;
}

void checkRepair(const Domain &domain, double tolerance) {
    const auto once = repair(domain, tolerance);
    if (!once) {
        demand(!once.faults().front().message.empty(), "a refusal says why");
        return;
    }
    checkDomain(once->domain);
    for (const Diagnostic &fault : validate(once->domain)) {
        demand(domain.insideRule == InsideRule::HoleMarkers || !repairable(fault), "a repair leaves nothing to repair");
    }
    for (const ArrangementChange &change : once->changes) {
        demand(change.displacement <= std::max(tolerance, 1e-9), "nothing moves farther than the tolerance");
    }
    const auto twice = repair(once->domain, once->radius);
    demand(twice.ok() && twice->changes.empty() && twice->domain.nodes == once->domain.nodes,
           "a second repair changes nothing");
}

/// Bytes as a domain: its nodes, then segments and points between them.
void repairs(std::string_view bytes) {
    ByteNumbers numbers(bytes);
    const Domain domain = domainFrom(numbers);
    checkRepair(domain, 0.0);
    checkRepair(domain, 0.25);
}

constexpr std::array kTargets = {
    Target{"project", project},
    Target{"geojson", domain<readGeoJson>},
    Target{"svg", domain<readSvg>},
    Target{"poly", domain<readPoly>},
    Target{"msh", msh},
    Target{"vtu", mesh<readVtu>},
    Target{"vtk", mesh<readVtk>},
    Target{"medit", mesh<readMedit>},
    Target{"inp", mesh<readAbaqus>},
    Target{"su2", mesh<readSu2>},
    Target{"triangle", triangle},
    Target{"obj", mesh<readObj>},
    Target{"repair", repairs},
};

} // namespace

std::span<const Target> targets() {
    return kTargets;
}

const Target *find(std::string_view name) {
    const auto found = std::find_if(kTargets.begin(), kTargets.end(), [&](const Target &t) { return name == t.name; });
    return found != kTargets.end() ? &*found : nullptr;
}

} // namespace forefront::fuzz
