#include "app/python/source/run.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/job.hpp"
#include "app/python/source/mesh.hpp"
#include "app/python/source/progress_calls.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/files/text/text_writer.hpp"
#include "core/teaching/film/film_files.hpp"
#include "core/teaching/page/run_page.hpp"
#include "core/teaching/trace/trace_write.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace forefront::python {

namespace {

/// Returns the segments of the front as an array of shape (s, 2, 2): segment, end, coordinate.
py::array frontArray(MeshStepper &run) {
    const std::vector<FrontSegmentView> front = withoutGil([&] { return run.front(); });
    py::array_t<double> array({static_cast<py::ssize_t>(front.size()), py::ssize_t{2}, py::ssize_t{2}});
    double *to = array.mutable_data();
    for (const FrontSegmentView &segment : front) {
        for (const Vec2 end : {segment.a, segment.b}) {
            *to++ = end.x;
            *to++ = end.y;
        }
    }
    return array;
}

py::dict candidateDict(const CandidateTrace &candidate) {
    py::dict row;
    row["at"] = py::make_tuple(candidate.position.x, candidate.position.y);
    row["node"] = candidate.node == kNoNode ? py::object(py::none()) : py::cast(index(candidate.node));
    row["alpha"] = candidate.alpha;
    row["score"] = candidate.score;
    row["rho"] = candidate.rho;
    row["verdict"] = std::string(wordOf(candidate.verdict));
    return row;
}

py::object explanationDict(MeshStepper &run) {
    const auto found = withoutGil([&] { return run.explanation(); });
    if (!found) {
        return py::none();
    }
    const AdvanceExplanation &advance = *found;
    const std::array<Vec2, 2> base = {advance.a, advance.b};
    py::list candidates, made;
    for (const CandidateTrace &candidate : advance.candidates) {
        candidates.append(candidateDict(candidate));
    }
    for (const auto &triangle : advance.made) {
        made.append(pointArray(triangle));
    }
    py::dict row;
    row["advance"] = advance.advance;
    row["base"] = pointArray(base);
    row["base_nodes"] = py::make_tuple(index(advance.nodeA), index(advance.nodeB));
    row["ideal"] = py::make_tuple(advance.ideal.x, advance.ideal.y);
    row["spacing"] = advance.rho;
    row["search_radius"] = advance.searchRadius;
    row["deferred"] = advance.deferred;
    row["candidates"] = candidates;
    row["tests"] = advance.tests.size();
    row["made"] = made;
    row["caption"] = caption(advance, advance.events.size());
    return row;
}

MeshStepper stepperOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces,
                      const MeshingOptions &options, const py::object &callback) {
    MeshingJob job = jobOf(domain, sizes, replaces, options);
    const Progress progress = progressOf(callback);
    return valueOrRaise(withoutGil([&] { return MeshStepper::create(std::move(job), progress); }));
}

std::string runPage(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options,
                    const std::string &title, std::uint64_t from, std::optional<std::uint64_t> steps,
                    const py::object &callback) {
    const MeshingJob job = jobOf(domain, sizes, replaces, options);
    const Progress progress = progressOf(callback);
    StringSink sink;
    const auto written = withoutGil([&] {
        TextWriter out(sink);
        auto result = writeRunPage(job, {title, from, steps}, out, progress);
        out.flush();
        return result;
    });
    raiseErrors(written ? Diagnostics() : written.faults());
    return sink.text;
}

py::tuple runFilm(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options,
                  const std::filesystem::path &output, const py::dict &given, const py::object &callback) {
    FilmPlan plan;
    plan.output = output;
    plan.title = output.stem().string();
    plan.from = given["start"].cast<std::uint64_t>();
    plan.steps = given["steps"].cast<std::optional<std::uint64_t>>();
    plan.frames = given["frames"].cast<int>();
    plan.width = given["width"].cast<int>();
    plan.speed = given["speed"].cast<double>();
    if (!given["layers"].is_none()) {
        plan.layers.shown.fill(false);
        for (const auto &word : given["layers"].cast<std::vector<std::string>>()) {
            const std::optional<FilmLayer> layer = fromWord<FilmLayer>(word);
            if (!layer) {
                throw py::value_error("layers: expected " + wordList<FilmLayer>() + ", got '" + word + "'");
            }
            plan.layers.shown[static_cast<std::size_t>(*layer)] = true;
        }
    }
    if (const std::string fault = outputFault(plan); !fault.empty()) {
        throw py::value_error("path: " + fault);
    }
    const MeshingJob job = jobOf(domain, sizes, replaces, options);
    const Progress progress = progressOf(callback);
    const WrittenFilm film = valueOrRaise(withoutGil([&] { return writeFilm(job, plan, progress); }));
    return py::make_tuple(film.frames, film.first, film.last);
}

std::string runTrace(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options,
                     std::optional<std::uint64_t> steps) {
    const MeshingJob job = jobOf(domain, sizes, replaces, options);
    const Progress progress = progressOf(py::none());
    StringSink sink;
    raiseErrors(withoutGil([&] {
        TextWriter out(sink);
        Status status = writeTrace(job, steps, out, progress);
        out.flush();
        return status;
    }));
    return sink.text;
}

/// Refuses the use of a run that was discarded because a callback raised an exception.
MeshStepper &live(MeshStepper &run) {
    if (run.empty()) {
        throw std::runtime_error("the run ended when a callback raised an exception; start another one");
    }
    return run;
}

/// Moves to a position and returns the one reached. Ctrl-C stops on the way, and the run goes on from there.
std::uint64_t moveTo(MeshStepper &run, std::uint64_t position) {
    const Interruption interruption;
    const std::uint64_t reached = withoutGil([&] {
        live(run).seek(position, interruption.progress());
        return run.position();
    });
    interruption.raise();
    return reached;
}

std::uint64_t advanceBy(MeshStepper &run, std::uint64_t count) {
    const std::uint64_t from = live(run).position();
    return moveTo(run, from + std::min(count, std::numeric_limits<std::uint64_t>::max() - from)) - from;
}

std::uint64_t retreatBy(MeshStepper &run, std::uint64_t count) {
    const std::uint64_t from = live(run).position();
    return from - moveTo(run, from - std::min(count, from));
}

} // namespace

void bindRun(py::module_ &module) {
    py::class_<MeshStepper>(module, "Stepper")
        .def(py::init(&stepperOf))
        .def_property_readonly("position", [](MeshStepper &run) { return live(run).position(); })
        .def_property_readonly("at_end", [](MeshStepper &run) { return live(run).atEnd(); })
        .def("advance", &advanceBy)
        .def("retreat", &retreatBy)
        .def("seek", [](MeshStepper &run, std::uint64_t position) { moveTo(run, position); })
        .def("finish",
             [](MeshStepper &run, const py::object &callback) {
                 const Progress progress = progressOf(callback);
                 return withoutGil([&] { return live(run).finish(progress); });
             })
        .def("front", [](MeshStepper &run) { return frontArray(live(run)); })
        .def("explanation", [](MeshStepper &run) { return explanationDict(live(run)); })
        .def("mesh", [](MeshStepper &run, const PythonDomain &domain) {
            PythonMesh mesh = pythonMesh(withoutGil([&] { return live(run).mesh(); }));
            mesh.notes = domain.notes;
            mesh.unit = domain.unit;
            mesh.system = domain.system;
            return mesh;
        });
    module.def("run_page", &runPage);
    module.def("run_film", &runFilm);
    module.def("run_trace", &runTrace);
}

} // namespace forefront::python
