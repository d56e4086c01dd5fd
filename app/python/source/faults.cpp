#include "app/python/source/faults.hpp"

#include <array>
#include <cstddef>
#include <pybind11/stl.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront::python {

namespace {

const char *severityWord(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

const char *kindWord(DomainPartKind kind) {
    constexpr std::array kWords = {"node", "segment", "point", "hole", "region"};
    return kWords[static_cast<std::size_t>(kind)];
}

py::object atOf(const Diagnostic &fault) {
    return fault.at ? py::object(py::make_tuple(fault.at->x, fault.at->y)) : py::object(py::none());
}

py::list partsOf(const Diagnostic &fault) {
    py::list parts;
    for (const DomainPart &part : fault.parts) {
        parts.append(py::make_tuple(kindWord(part.kind), part.index));
    }
    return parts;
}

/// What messages for the command line call options of readers, and what they are in Python. Longer ones come first.
constexpr std::array kOptionNames = {
    std::pair("--no-white-holes", "white_holes=False"),
    std::pair("--curve-tolerance ", "curve_tolerance="),
    std::pair("--curve-tolerance", "curve_tolerance"),
    std::pair("--allow-degrees", "degrees='keep'"),
    std::pair("--shape-regions", "shape_regions=True"),
    std::pair("--name-property", "names"),
    std::pair("--stroke-areas", "stroke_areas=True"),
    std::pair("--white-holes", "white_holes=True"),
    std::pair("--drop-lines", "drop_lines=True"),
    std::pair("--projection local", "projection='local'"),
    std::pair("--projection", "projection"),
    std::pair("--repair", "repair=True"),
    std::pair("--strict", "strict"),
    std::pair("--layer", "layer"),
    std::pair("--weld ", "weld="),
};

/// Returns a text with the options of readers as arguments in Python.
std::string inPython(std::string text) {
    for (const auto &[option, argument] : kOptionNames) {
        for (std::size_t at = text.find(option); at != std::string::npos; at = text.find(option, at)) {
            text.replace(at, std::string_view(option).size(), argument);
            at += std::string_view(argument).size();
        }
    }
    return text;
}

std::string textOf(Diagnostic fault) {
    fault.message = inPython(std::move(fault.message));
    fault.advice = inPython(std::move(fault.advice));
    return toString(fault);
}

} // namespace

void bindFaults(py::module_ &module) {
    py::class_<Diagnostic>(module, "Fault", "A fault, warning or note: what is wrong, where, and how to fix it.")
        .def_property_readonly(
            "severity", [](const Diagnostic &fault) { return severityWord(fault.severity); },
            "'error', 'warning' or 'note'")
        .def_readonly("code", &Diagnostic::code, "Stable identifier, such as 'crossing-segments'")
        .def_property_readonly(
            "message", [](const Diagnostic &fault) { return inPython(fault.message); },
            "What is wrong, with the value and what was expected")
        .def_property_readonly(
            "advice", [](const Diagnostic &fault) { return inPython(fault.advice); }, "How to fix it; may be empty")
        .def_property_readonly("at", &atOf, "Place (x, y) in domain units, or None")
        .def_property_readonly("parts", &partsOf,
                               "Parts of the domain involved, as tuples (kind, index); the kind is 'node', 'segment', "
                               "'point', 'hole' or 'region'")
        .def_readonly("ids", &Diagnostic::ids, "Indices of the nodes or elements of a mesh in the message")
        .def_readonly("file", &Diagnostic::file, "File that holds the fault; empty if none does")
        .def_readonly("line", &Diagnostic::line, "Line of the file, from 1; 0 if unknown")
        .def_readonly("column", &Diagnostic::column, "Column of the line, from 1; 0 if unknown")
        .def("__str__", [](const Diagnostic &fault) { return textOf(fault); })
        .def("__repr__", [](const Diagnostic &fault) { return "<Fault " + textOf(fault) + ">"; })
        .def(py::pickle(
            [](const Diagnostic &fault) {
                return py::make_tuple(static_cast<int>(fault.severity), fault.code, fault.message, fault.advice,
                                      atOf(fault), fault.ids, fault.file, fault.line, fault.column);
            },
            [](const py::tuple &state) {
                Diagnostic fault;
                fault.severity = static_cast<Severity>(state[0].cast<int>());
                fault.code = state[1].cast<std::string>();
                fault.message = state[2].cast<std::string>();
                fault.advice = state[3].cast<std::string>();
                if (!state[4].is_none()) {
                    const auto at = state[4].cast<std::pair<double, double>>();
                    fault.at = Vec2{at.first, at.second};
                }
                fault.ids = state[5].cast<std::vector<std::uint32_t>>();
                fault.file = state[6].cast<std::string>();
                fault.line = state[7].cast<int>();
                fault.column = state[8].cast<int>();
                return fault;
            }));
    module.def(
        "fault",
        [](const std::string &code, const std::string &message, const std::string &advice,
           const std::optional<std::pair<double, double>> &at, bool note) {
            Diagnostic fault = error(code, message, advice).front();
            fault.severity = note ? Severity::Note : Severity::Error;
            if (at) {
                fault.at = Vec2{at->first, at->second};
            }
            return fault;
        },
        py::arg("code"), py::arg("message"), py::arg("advice") = "", py::arg("at") = py::none(),
        py::arg("note") = false, "Makes an error or a note of the Python package itself");
}

py::list faultList(const Diagnostics &faults) {
    py::list list;
    for (const Diagnostic &fault : faults) {
        list.append(py::cast(fault));
    }
    return list;
}

void raiseFaults(const Diagnostics &faults) {
    const py::object type = py::module_::import("forefront._errors").attr("MeshError");
    PyErr_SetObject(type.ptr(), type(faultList(faults)).ptr());
    throw py::error_already_set();
}

} // namespace forefront::python
