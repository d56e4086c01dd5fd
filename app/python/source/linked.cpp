#include "app/python/source/arrays.hpp"
#include "app/python/source/domain.hpp"

#include <optional>
#include <pybind11/stl.h>
#include <string>

namespace forefront::python {

namespace {

template <class Enum>
Enum wordOrRaise(const char *what, const std::string &word) {
    const std::optional<Enum> known = fromWord<Enum>(word);
    if (!known) {
        throw py::value_error(std::string(what) + ": expected " + wordList<Enum>() + ", got '" + word + "'");
    }
    return *known;
}

/// Adds a specification in place of those of the same part.
template <class Spec, class Key>
void put(std::vector<Spec> &list, const Spec &spec, Key Spec::*key) {
    std::erase_if(list, [&](const Spec &own) { return own.*key == spec.*key; });
    list.push_back(spec);
}

void addLayers(PythonDomain &self, const py::object &part, double first, double growth,
               std::optional<std::uint32_t> count, std::optional<double> thickness, const std::string &elements) {
    const auto cells = wordOrRaise<LayerCells>("elements", elements);
    put(self.layers, {boundaryTag(self.domain, part), first, growth, count, thickness, cells}, &LayerSpec::tag);
}

void addCrack(PythonDomain &self, const py::object &line) {
    const std::int32_t tag = boundaryTag(self.domain, line);
    std::erase(self.cracks, tag);
    self.cracks.push_back(tag);
}

void addPeriodic(PythonDomain &self, const py::object &first, const py::object &second) {
    const std::int32_t from = boundaryTag(self.domain, first);
    put(self.periodic, {from, boundaryTag(self.domain, second)}, &PeriodicSpec::from);
    std::erase(self.periodicOfMesh, self.periodic.back());
}

void addMapped(PythonDomain &self, const py::object &region, const std::optional<ArrayOf<double>> &corners) {
    put(self.mapped, {regionTag(self.domain, region), corners ? pointsOf(*corners, "corners") : std::vector<Vec2>()},
        &MappedSpec::region);
}

void addStrip(PythonDomain &self, const py::object &line, double width, std::uint32_t rows, const std::string &elements,
              const py::object &region) {
    const auto cells = wordOrRaise<LayerCells>("elements", elements);
    const std::int32_t tag = boundaryTag(self.domain, line);
    put(self.strips, {tag, width, rows, cells, region.is_none() ? 0 : regionTag(self.domain, region)}, &StripSpec::tag);
}

void setRegionElements(PythonDomain &self, const py::object &region, const std::string &elements) {
    const auto shapes = wordOrRaise<Elements>("elements", elements);
    put(self.regionElements, {regionTag(self.domain, region), shapes}, &RegionElements::region);
}

} // namespace

void bindLinked(py::class_<PythonDomain> &domain) {
    domain
        .def("add_layers", &addLayers, py::arg("part"), py::arg("first"), py::arg("growth") = 1.2,
             py::arg("count") = py::none(), py::arg("thickness") = py::none(), py::arg("elements") = "quads")
        .def("add_crack", &addCrack, py::arg("line"))
        .def("add_periodic", &addPeriodic, py::arg("first"), py::arg("second"))
        .def("add_mapped", &addMapped, py::arg("region"), py::arg("corners") = py::none())
        .def("add_strip", &addStrip, py::arg("line"), py::arg("width"), py::arg("rows"), py::arg("elements") = "quads",
             py::arg("region") = py::none())
        .def("set_elements", &setRegionElements, py::arg("region"), py::arg("elements"));
}

} // namespace forefront::python
