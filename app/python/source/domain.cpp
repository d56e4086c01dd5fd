#include "app/python/source/domain.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/progress_calls.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/curved_bounds.hpp"
#include "core/engine/domain/validate.hpp"

#include <map>
#include <numbers>
#include <pybind11/stl.h>

namespace forefront::python {

namespace {

/// Chords that stand for a circle: they deviate from it by 1/800 of its radius.
constexpr std::uint32_t kCircleChords = 64;

using Names = std::map<std::int32_t, std::string>;

/// Returns the tag of a name, which is added with the next free tag if it is new. `used`: the largest tag in use.
std::int32_t tagOfName(Names &names, const std::string &name, std::int32_t used) {
    for (const auto &[tag, known] : names) {
        if (known == name) {
            return tag;
        }
    }
    const std::int32_t tag = (names.empty() ? used : std::max(used, names.rbegin()->first)) + 1;
    names[tag] = name;
    return tag;
}

std::int32_t largestTag(const Domain &domain) {
    std::int32_t tag = 0;
    for (const DomainSegment &segment : domain.segments) {
        tag = std::max(tag, segment.tag);
    }
    for (const ConstraintPoint &point : domain.points) {
        tag = std::max(tag, point.tag);
    }
    return tag;
}

} // namespace

std::int32_t boundaryTag(Domain &domain, const py::handle &part) {
    if (part.is_none()) {
        return 1;
    }
    if (py::isinstance<py::str>(part)) {
        return tagOfName(domain.boundaryNames, part.cast<std::string>(), largestTag(domain));
    }
    return part.cast<std::int32_t>();
}

std::int32_t regionTag(Domain &domain, const py::handle &part) {
    std::int32_t used = 0;
    for (const RegionMarker &marker : domain.regionMarkers) {
        used = std::max(used, marker.tag);
    }
    return py::isinstance<py::str>(part) ? tagOfName(domain.regionNames, part.cast<std::string>(), used)
                                         : part.cast<std::int32_t>();
}

namespace {

bool isSequence(const py::object &names) {
    return !names.is_none() && !py::isinstance<py::str>(names) && py::isinstance<py::sequence>(names);
}

/// Names the segments from `first` on: by one name or tag for all of them, or a sequence with one for each.
void nameSegments(Domain &domain, std::size_t first, const py::object &names) {
    const std::size_t count = domain.segments.size() - first;
    if (!isSequence(names)) {
        const std::int32_t tag = boundaryTag(domain, names);
        for (std::size_t k = 0; k < count; ++k) {
            domain.segments[first + k].tag = tag;
        }
        return;
    }
    const auto list = names.cast<py::sequence>();
    if (list.size() != count) {
        domain.segments.resize(first);
        throw py::value_error("names: expected one name for each of the " + std::to_string(count) + " segments, got " +
                              std::to_string(list.size()));
    }
    for (std::size_t k = 0; k < count; ++k) {
        domain.segments[first + k].tag = boundaryTag(domain, list[k]);
    }
}

void addLoopTo(PythonDomain &self, const ArrayOf<double> &points, const py::object &names) {
    const std::vector<Vec2> nodes = pointsOf(points, "points");
    const std::size_t firstNode = self.domain.nodes.size(), first = self.domain.segments.size();
    addLoop(self.domain, nodes);
    try {
        nameSegments(self.domain, first, names);
    } catch (...) {
        self.domain.segments.resize(first);
        self.domain.nodes.resize(firstNode);
        throw;
    }
}

void addLineTo(PythonDomain &self, const ArrayOf<double> &points, const py::object &names, bool closed) {
    const std::vector<Vec2> nodes = pointsOf(points, "points");
    const std::size_t firstNode = self.domain.nodes.size(), first = self.domain.segments.size();
    addLoop(self.domain, nodes);
    if (!closed && !nodes.empty()) {
        self.domain.segments.pop_back();
    }
    for (std::size_t k = first; k < self.domain.segments.size(); ++k) {
        self.domain.segments[k].role = SegmentRole::Constraint;
    }
    try {
        nameSegments(self.domain, first, names);
    } catch (...) {
        self.domain.segments.resize(first);
        self.domain.nodes.resize(firstNode);
        throw;
    }
}

void addCircleTo(PythonDomain &self, const py::object &centre, double radius, const py::object &name, bool line) {
    if (!(radius > 0.0)) {
        throw py::value_error("radius: expected a positive number");
    }
    Domain &domain = self.domain;
    const Vec2 middle = pointOf(centre, "centre");
    const Curve circle = Curve::circle(middle, middle + Vec2{radius, 0.0});
    std::vector<Vec2> nodes;
    for (std::uint32_t k = 0; k < kCircleChords; ++k) {
        nodes.push_back(circle.point(static_cast<double>(k) / kCircleChords));
    }
    const LoopRange loop = addLoop(domain, nodes, boundaryTag(domain, name));
    const auto number = static_cast<std::uint32_t>(domain.curves.size());
    domain.curves.push_back(circle);
    for (std::uint32_t k = 0; k < kCircleChords; ++k) {
        DomainSegment &segment = domain.segments[loop.firstSegment + k];
        segment.stretch = {number, static_cast<double>(k) / kCircleChords, static_cast<double>(k + 1) / kCircleChords};
        segment.role = line ? SegmentRole::Constraint : SegmentRole::Boundary;
    }
}

void addPointTo(PythonDomain &self, const py::object &at, const py::object &name, std::optional<double> size,
                double growth) {
    const Vec2 place = pointOf(at, "at");
    const auto node = static_cast<std::uint32_t>(self.domain.nodes.size());
    self.domain.nodes.push_back(place);
    self.domain.points.push_back({node, boundaryTag(self.domain, name)});
    if (size) {
        self.spacing.placed.nodes.push_back({place, *size, growth});
    }
}

void addRegion(PythonDomain &self, const py::object &at, const py::object &name, std::optional<double> size,
               std::optional<double> maxArea, double growth) {
    const Vec2 place = pointOf(at, "at");
    self.domain.regionMarkers.push_back({place, regionTag(self.domain, name)});
    if (size || maxArea) {
        self.spacing.placed.regions.push_back({place, maxArea.value_or(0.0), size.value_or(0.0), growth});
    }
}

void addHole(PythonDomain &self, const py::object &at) {
    self.domain.holeMarkers.push_back(pointOf(at, "at"));
    self.domain.insideRule = InsideRule::HoleMarkers;
}

/// Adds nodes and segments in one step, as files such as .poly list them.
void addSegments(PythonDomain &self, const ArrayOf<double> &points, const ArrayOf<std::int64_t> &segments,
                 const std::optional<ArrayOf<std::int32_t>> &tags) {
    const std::vector<Vec2> nodes = pointsOf(points, "points");
    if (segments.size() > 0 && (segments.ndim() != 2 || segments.shape(1) != 2)) {
        throw py::value_error("segments: expected an array of shape (k, 2)");
    }
    const auto count = segments.size() / 2;
    if (tags && tags->size() != count) {
        throw py::value_error("tags: expected one for each of the " + std::to_string(count) + " segments, got " +
                              std::to_string(tags->size()));
    }
    const auto known = static_cast<std::int64_t>(nodes.size());
    for (py::ssize_t k = 0; k < segments.size(); ++k) {
        if (const std::int64_t node = segments.data()[k]; node < 0 || node >= known) {
            throw py::value_error("segments: node " + std::to_string(node) + " does not exist; expected 0 to " +
                                  std::to_string(known - 1));
        }
    }
    const auto first = static_cast<std::uint32_t>(self.domain.nodes.size());
    self.domain.nodes.insert(self.domain.nodes.end(), nodes.begin(), nodes.end());
    for (py::ssize_t k = 0; k < count; ++k) {
        self.domain.segments.push_back({first + static_cast<std::uint32_t>(segments.data()[2 * k]),
                                        first + static_cast<std::uint32_t>(segments.data()[2 * k + 1]),
                                        tags ? tags->data()[k] : 1, SegmentRole::Boundary});
    }
}

py::array segmentArray(const PythonDomain &self) {
    const auto &segments = self.domain.segments;
    py::array_t<std::uint32_t> array({static_cast<py::ssize_t>(segments.size()), py::ssize_t{2}});
    std::uint32_t *to = array.mutable_data();
    for (const DomainSegment &segment : segments) {
        *to++ = segment.a;
        *to++ = segment.b;
    }
    return array;
}

py::array segmentTags(const PythonDomain &self) {
    std::vector<std::int32_t> tags;
    for (const DomainSegment &segment : self.domain.segments) {
        tags.push_back(segment.tag);
    }
    return copyOfValues<std::int32_t>(tags);
}

py::list regionList(const PythonDomain &self) {
    py::list list;
    for (const RegionMarker &marker : self.domain.regionMarkers) {
        list.append(py::make_tuple(py::make_tuple(marker.at.x, marker.at.y), marker.tag));
    }
    return list;
}

py::tuple repairDomain(const PythonDomain &self, double tolerance) {
    const Domain domain = self.domain; // another thread may change it meanwhile
    PythonDomain result = self;
    Repaired repaired = valueOrRaise(withoutGil([&] { return repair(domain, tolerance); }));
    Diagnostics changes = notesWithPlaces(repaired.changes);
    const Diagnostics losses = carryElements(domain, repaired, result.spacing);
    changes.insert(changes.end(), losses.begin(), losses.end());
    result.domain = std::move(repaired.domain);
    result.notes.insert(result.notes.end(), changes.begin(), changes.end());
    return py::make_tuple(std::move(result), faultList(changes));
}

void bindParts(py::class_<PythonDomain> &domain) {
    domain.def("add_loop", &addLoopTo, py::arg("points"), py::arg("names") = py::none())
        .def("add_line", &addLineTo, py::arg("points"), py::arg("names") = py::none(), py::arg("closed") = false)
        .def("add_circle", &addCircleTo, py::arg("centre"), py::arg("radius"), py::arg("name") = py::none(),
             py::arg("line") = false)
        .def("add_point", &addPointTo, py::arg("at"), py::arg("name") = py::none(), py::arg("size") = py::none(),
             py::arg("growth") = 0.2)
        .def("add_segments", &addSegments, py::arg("points"), py::arg("segments"), py::arg("tags") = py::none())
        .def("region", &addRegion, py::arg("at"), py::arg("name"), py::arg("size") = py::none(),
             py::arg("max_area") = py::none(), py::arg("growth") = 0.2)
        .def("hole", &addHole, py::arg("at"));
}

void bindProperties(py::class_<PythonDomain> &domain) {
    domain
        .def_property_readonly(
            "nodes", [](const PythonDomain &self) { return pointArray(self.domain.nodes); },
            "The nodes as given, a copy: shape (n, 2).")
        .def_property_readonly(
            "segments", &segmentArray,
            "The segments of the boundary and of lines, a copy: shape (k, 2), indices into ``nodes``. "
            "Those of curves are chords.")
        .def_property_readonly("segment_tags", &segmentTags,
                               "The tag of each segment, a copy: shape (k,); ``boundary_names`` has their names.")
        .def_property_readonly(
            "holes", [](const PythonDomain &self) { return pointArray(self.domain.holeMarkers); },
            "The points that mark holes, a copy: shape (h, 2); they count only if ``marks_holes``.")
        .def_property_readonly(
            "regions", &regionList,
            "The region markers, as a list of ((x, y), tag); ``region_names`` has the names of tags.")
        .def_property(
            "boundary_names", [](const PythonDomain &self) { return self.domain.boundaryNames; },
            [](PythonDomain &self, Names names) { self.domain.boundaryNames = std::move(names); },
            "The names of boundary parts by tag, a copy: assign a dict to change them. A tag without an entry is "
            "'boundary_TAG'.")
        .def_property(
            "region_names", [](const PythonDomain &self) { return self.domain.regionNames; },
            [](PythonDomain &self, Names names) { self.domain.regionNames = std::move(names); },
            "The names of regions by tag, a copy: assign a dict to change them. A tag without an entry is "
            "'region_TAG'.")
        .def_property(
            "curve_tolerance", [](const PythonDomain &self) { return self.domain.curveTolerance; },
            [](PythonDomain &self, double tolerance) { self.domain.curveTolerance = tolerance; },
            "The maximum distance of a curve from its edges in the mesh, in units of the coordinates; 0: 1/2000 of the "
            "diagonal of the domain.")
        .def_property(
            "marks_holes", [](const PythonDomain &self) { return self.domain.insideRule == InsideRule::HoleMarkers; },
            [](PythonDomain &self, bool marked) {
                self.domain.insideRule = marked ? InsideRule::HoleMarkers : InsideRule::EvenOdd;
            },
            "Whether only faces with a marker are holes; otherwise, a loop inside another one is a hole.")
        .def_property_readonly("_notes", [](const PythonDomain &self) { return faultList(self.notes); })
        .def("_add_notes",
             [](PythonDomain &self, const Diagnostics &notes) {
                 self.notes.insert(self.notes.end(), notes.begin(), notes.end());
             })
        .def_property_readonly(
            "bounds",
            [](const PythonDomain &self) {
                const Box2 box = curvedBounds(self.domain);
                return py::make_tuple(box.min.x, box.min.y, box.max.x, box.max.y);
            },
            "The box around all nodes and curves: (x_min, y_min, x_max, y_max).");
}

} // namespace

void namePartsOf(std::span<const PartName> parts, PythonDomain &domain) {
    const Diagnostics notes = nameParts(parts, domain.domain);
    raiseErrors(notes);
    domain.notes.insert(domain.notes.end(), notes.begin(), notes.end());
}

void bindDomain(py::module_ &module) {
    py::class_<PythonDomain> domain(module, "DomainBase");
    domain.def(py::init<>()).def(py::init<const PythonDomain &>());
    bindParts(domain);
    bindLinked(domain);
    bindProperties(domain);
    domain
        .def(
            "validate",
            [](const PythonDomain &self, std::size_t limit) {
                const Domain copy = self.domain; // another thread may change it meanwhile
                return faultList(withoutGil([&] { return validate(copy, limit); }));
            },
            py::arg("limit") = kMaxListedFaults)
        .def(
            "name_part",
            [](PythonDomain &self, const std::string &name, const py::object &from, const py::object &to) {
                if (name.empty()) {
                    throw py::value_error("name: expected a name of the part");
                }
                const PartName part{name, pointOf(from, "start"), pointOf(to.is_none() ? from : to, "end")};
                namePartsOf(std::span(&part, 1), self);
            },
            py::arg("name"), py::arg("start"), py::arg("end") = py::none())
        .def("_limit_area",
             [](PythonDomain &self, const py::object &at, double area) {
                 self.spacing.placed.regions.push_back({pointOf(at, "at"), area, 0.0});
             })
        .def("_repair", &repairDomain, py::arg("tolerance"));
}

} // namespace forefront::python
