#include "app/python/source/job.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/progress_calls.hpp"
#include "app/python/source/shared_object.hpp"
#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/engine/spacing/spec/size_grid.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"
#include "core/files/elevations.hpp"
#include "core/files/rules/rules_json.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace forefront::python {

namespace {

/// Calls a size function of Python with arrays x and y. The GIL is taken for the call.
void callSizes(const py::object &function, std::span<const Vec2> positions, std::span<double> sizes) {
    const py::gil_scoped_acquire gil;
    const auto count = static_cast<py::ssize_t>(positions.size());
    py::array_t<double> x(count), y(count);
    double *const toX = x.mutable_data(), *const toY = y.mutable_data();
    for (std::size_t k = 0; k < positions.size(); ++k) {
        toX[k] = positions[k].x;
        toY[k] = positions[k].y;
    }
    const ArrayOf<double> values(function(x, y));
    if (values.ndim() == 0) {
        std::fill(sizes.begin(), sizes.end(), *values.data());
    } else if (values.ndim() == 1 && values.size() == count) {
        std::copy_n(values.data(), sizes.size(), sizes.begin());
    } else {
        throw py::value_error("size: expected the function to return one value for each of the " +
                              std::to_string(count) + " points, or one number; got " + std::to_string(values.size()) +
                              " values");
    }
}

void setFunction(SpacingSpec &self, const py::object &function) {
    const SharedObject held = sharedObject(function);
    self.bulkFunction = [held](std::span<const Vec2> positions, std::span<double> sizes) {
        callSizes(*held, positions, sizes);
    };
}

void setGrid(SpacingSpec &self, const ArrayOf<double> &values, const py::object &origin, const py::object &pitch) {
    if (values.ndim() != 2) {
        throw py::value_error("values: expected an array of shape (rows, columns)");
    }
    SizeGrid grid;
    grid.origin = pointOf(origin, "origin");
    grid.pitch = pointOf(pitch, "pitch");
    grid.rows = static_cast<std::size_t>(values.shape(0));
    grid.columns = static_cast<std::size_t>(values.shape(1));
    grid.values.assign(values.data(), values.data() + values.size());
    self.background = valueOrRaise(backgroundOf(grid));
}

void checkName(const std::string &name) {
    if (const std::string wrong = checkRasterName(name); !wrong.empty()) {
        throw py::value_error("rasters: " + wrong);
    }
}

/// Reads a raster that the expression calls by its name. Returns the notes of the reader.
py::list readRasterFile(SpacingSpec &self, const std::string &name, const std::filesystem::path &path) {
    checkName(name);
    ImportNotes notes;
    Raster raster = valueOrRaise(withoutGil([&] { return readRaster(path, {}, &notes); }));
    self.rasters[name] = std::make_shared<const Raster>(std::move(raster));
    return faultList(notes.diagnostics());
}

void setRaster(SpacingSpec &self, const std::string &name, const ArrayOf<double> &values, const py::object &origin,
               const py::object &pitch) {
    checkName(name);
    if (values.ndim() != 2 || values.size() == 0) {
        throw py::value_error("rasters: expected values of shape (rows, columns)");
    }
    auto raster = std::make_shared<Raster>();
    raster->origin = pointOf(origin, "origin");
    raster->pitch = pointOf(pitch, "pitch");
    const auto positive = [](double length) { return std::isfinite(length) && length > 0.0; };
    if (!positive(raster->pitch.x) || !positive(raster->pitch.y) || !std::isfinite(raster->origin.x) ||
        !std::isfinite(raster->origin.y)) {
        throw py::value_error("rasters: expected a finite origin and a pitch above 0");
    }
    raster->rows = static_cast<std::size_t>(values.shape(0));
    raster->columns = static_cast<std::size_t>(values.shape(1));
    raster->values.assign(values.data(), values.data() + values.size());
    self.rasters[name] = std::move(raster);
}

/// Takes the rules of the classic method from JSON, once the elements and the method are set.
void setRules(MeshingOptions &self, const std::string &json) {
    if (self.elements != Elements::Triangles) {
        throw py::value_error("rules: quadrilaterals have a front of their own, without these rules; leave out rules, "
                              "or give elements='triangles', method='classic'");
    }
    if (self.method != Method::Classic) {
        throw py::value_error("rules: the fast method has no such rules; add method='classic'");
    }
    SourceText source;
    source.text = json;
    source.name = "rules";
    self.rules = valueOrRaise(readRulesText(source));
}

void setUniformGrid(MeshingOptions &self, int columns, int rows) {
    constexpr int kMaxCells = 100'000;
    if (std::min(columns, rows) < 1 || std::max(columns, rows) > kMaxCells) {
        throw py::value_error("grid: expected 1 to " + std::to_string(kMaxCells) + " columns and rows");
    }
    self.grid = GridKind::Uniform;
    self.gridColumns = columns;
    self.gridRows = rows;
}

void setBackground(SpacingSpec &self, const ArrayOf<double> &nodes, const ArrayOf<std::uint32_t> &elements,
                   const ArrayOf<double> &values) {
    auto mesh = std::make_shared<BackgroundMesh>();
    mesh->nodes = pointsOf(nodes, "nodes");
    if (elements.ndim() != 2 || elements.shape(1) != 3) {
        throw py::value_error("elements: expected an array of shape (m, 3)");
    }
    if (static_cast<std::size_t>(values.size()) != mesh->nodes.size()) {
        throw py::value_error("values: expected one for each of the " + std::to_string(mesh->nodes.size()) +
                              " nodes, got " + std::to_string(values.size()));
    }
    for (py::ssize_t k = 0; k < elements.size(); k += 3) {
        const std::uint32_t *const e = elements.data() + k;
        if (std::max({e[0], e[1], e[2]}) >= mesh->nodes.size()) {
            throw py::value_error("elements: element " + std::to_string(k / 3) + " names a node that does not exist");
        }
        mesh->elements.push_back({e[0], e[1], e[2]});
    }
    mesh->values.assign(values.data(), values.data() + values.size());
    self.background = mesh;
}

void addSource(SpacingSpec &self, const std::string &shape, const py::object &a, const py::object &b, double size,
               double growth, double radius, const std::string &name, std::optional<double> endSize, double angle,
               bool gradient, bool geometric) {
    const std::optional<SourceShape> known = fromWord<SourceShape>(shape);
    if (!known) {
        throw py::value_error("shape: expected " + wordList<SourceShape>() + ", got '" + shape + "'");
    }
    SizeSource source{*known, pointOf(a, "a"), pointOf(b, "b"), radius, size, growth, name};
    source.endSize = endSize;
    source.angle = angle;
    source.plane = gradient;
    source.geometric = geometric;
    self.sources.push_back(source);
}

template <class Enum>
void setWord(Enum &value, const char *what, const std::string &word) {
    const std::optional<Enum> known = fromWord<Enum>(word);
    if (!known) {
        throw py::value_error(std::string(what) + ": expected " + wordList<Enum>() + ", got '" + word + "'");
    }
    value = *known;
}

void bindSizes(py::module_ &module) {
    py::class_<SpacingSpec>(module, "Sizes")
        .def(py::init<>())
        .def(py::init<const SpacingSpec &>())
        .def_readwrite("size", &SpacingSpec::size)
        .def_readwrite("expression", &SpacingSpec::expression)
        .def_property(
            "names",
            [](const SpacingSpec &self) { return std::map<std::string, double>(self.names.begin(), self.names.end()); },
            [](SpacingSpec &self, const std::map<std::string, double> &names) {
                self.names = {names.begin(), names.end()};
            })
        .def_readwrite("keep_automatic", &SpacingSpec::keepAutomatic)
        .def_readwrite("from_boundary", &SpacingSpec::fromBoundary)
        .def_readwrite("segments_per_turn", &SpacingSpec::segmentsPerTurn)
        .def_readwrite("elements_across", &SpacingSpec::elementsAcross)
        .def_readwrite("minimum", &SpacingSpec::minimum)
        .def_readwrite("maximum", &SpacingSpec::maximum)
        .def_readwrite("gradation", &SpacingSpec::gradation)
        .def("set_function", &setFunction)
        .def("set_grid", &setGrid)
        .def("set_background", &setBackground)
        .def("read_raster", &readRasterFile)
        .def("set_raster", &setRaster)
        .def("add_source", &addSource)
        .def("set_part",
             [](SpacingSpec &self, std::int32_t tag, double size, double growth) {
                 self.partSizes[tag] = {size, growth};
             })
        .def("add_node",
             [](SpacingSpec &self, const py::object &at, double size, double growth) {
                 self.placed.nodes.push_back({pointOf(at, "at"), size, growth});
             })
        .def("add_region", [](SpacingSpec &self, const py::object &at, double size, double maxArea, double growth) {
            self.placed.regions.push_back({pointOf(at, "at"), maxArea, size, growth});
        });
}

void bindOptions(py::module_ &module) {
    py::class_<MeshingOptions>(module, "Options")
        .def(py::init<>())
        .def(py::init([](const PythonDomain &domain) { return domain.options; }))
        .def("set_elements",
             [](MeshingOptions &self, const std::string &word) { setWord(self.elements, "elements", word); })
        .def("set_method", [](MeshingOptions &self, const std::string &word) { setWord(self.method, "method", word); })
        .def("set_grid", [](MeshingOptions &self, const std::string &word) { setWord(self.grid, "grid", word); })
        .def("set_improve",
             [](MeshingOptions &self, const std::string &word) { setWord(self.improve, "improve", word); })
        .def("set_order", [](MeshingOptions &self, const std::string &word) { setWord(self.order, "order", word); })
        .def("set_quad_nodes",
             [](MeshingOptions &self, const std::string &word) { setWord(self.quadNodes, "quad_nodes", word); })
        .def("set_rules", &setRules)
        .def("set_uniform_grid", &setUniformGrid)
        .def_readwrite("keep_boundary", &MeshingOptions::keepBoundary)
        .def_readwrite("min_angle", &MeshingOptions::leastAngle)
        .def_readwrite("threads", &MeshingOptions::threads)
        .def_readwrite("max_elements", &MeshingOptions::maxElements)
        .def_readwrite("verify", &MeshingOptions::verify);
}

} // namespace

void bindJob(py::module_ &module) {
    bindSizes(module);
    bindOptions(module);
    module.def("preset_expression",
               [](const std::vector<std::string> &rules) { return valueOrRaise(presetExpression(rules)); });
}

MeshingJob jobOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options) {
    MeshingJob job{domain.domain, domain.spacing, options};
    job.cracks = domain.cracks;
    job.periodic = domain.periodic;
    job.mapped = domain.mapped;
    job.strips = domain.strips;
    job.layers = domain.layers;
    job.regionElements = domain.regionElements;
    SpacingSpec &spacing = job.spacing;
    // The parameters and rasters of a project hold for other expressions, too.
    auto names = spacing.names;
    auto rasters = spacing.rasters;
    for (const auto &[name, value] : sizes.names) {
        names[name] = value;
    }
    for (const auto &[name, raster] : sizes.rasters) {
        rasters[name] = raster;
    }
    if (replaces) {
        spacing.replaceRules(sizes);
    } else {
        const auto take = [](auto &to, const auto &from) {
            if (from) {
                to = from;
            }
        };
        take(spacing.keepAutomatic, sizes.keepAutomatic);
        take(spacing.segmentsPerTurn, sizes.segmentsPerTurn);
        take(spacing.elementsAcross, sizes.elementsAcross);
        take(spacing.minimum, sizes.minimum);
        take(spacing.maximum, sizes.maximum);
        take(spacing.gradation, sizes.gradation);
        spacing.fromBoundary = spacing.fromBoundary || sizes.fromBoundary;
        spacing.sources.insert(spacing.sources.end(), sizes.sources.begin(), sizes.sources.end());
        for (const auto &[tag, size] : sizes.partSizes) {
            spacing.partSizes[tag] = size;
        }
    }
    spacing.names = std::move(names);
    spacing.rasters = std::move(rasters);
    const PlacedSizes &placed = sizes.placed;
    spacing.placed.nodes.insert(spacing.placed.nodes.end(), placed.nodes.begin(), placed.nodes.end());
    spacing.placed.regions.insert(spacing.placed.regions.end(), placed.regions.begin(), placed.regions.end());
    return job;
}

MeshLimits limitsOf(const char *what, const std::map<std::string, double> &given) {
    MeshLimits limits;
    for (const auto &[word, value] : given) {
        const std::optional<MeshLimit> limit = fromWord<MeshLimit>(word);
        if (!limit) {
            throw py::value_error(std::string(what) + ": expected " + wordList<MeshLimit>() + ", got '" + word + "'");
        }
        if (const std::string fault = limitFault(*limit, value); !fault.empty()) {
            throw py::value_error(std::string(word).append(": ").append(fault));
        }
        limits[*limit] = value;
    }
    return limits;
}

} // namespace forefront::python
