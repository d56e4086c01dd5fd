#include "core/c/handles.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/files/files.hpp"

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

using forefront::Vec2;
using forefront::c::badArgument;
using forefront::c::guarded;
using forefront::c::report;

namespace {

std::vector<Vec2> placesOf(const double *places, std::size_t count) {
    std::vector<Vec2> list(count);
    for (std::size_t k = 0; k < count; ++k) {
        list[k] = {places[2 * k], places[2 * k + 1]};
    }
    return list;
}

/// Runs a change of a job, which must not be null.
template <class Change>
forefront_status changed(forefront_context *context, forefront_job *job, const Change &change) {
    return guarded(context,
                   [&] { return job == nullptr ? badArgument(*context, "the job is null") : change(job->job); });
}

template <class Number>
std::optional<Number> numberOf(std::string_view text) {
    Number number{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional<Number>(number) : std::nullopt;
}

template <class Enum>
forefront_status setWord(forefront_context &context, Enum &value, const char *name, std::string_view text) {
    const std::optional<Enum> known = forefront::fromWord<Enum>(text);
    if (!known) {
        return badArgument(context, std::string(name) + ": expected " + forefront::wordList<Enum>() + ", got '" +
                                        std::string(text) + "'");
    }
    value = *known;
    return FOREFRONT_OK;
}

template <class Number, class Value>
forefront_status setNumber(forefront_context &context, Value &value, const char *name, std::string_view text,
                           Number minimum) {
    const std::optional<Number> number = numberOf<Number>(text);
    if (!number || !(*number >= minimum)) {
        return badArgument(context, std::string(name) + ": expected a number from " +
                                        forefront::numberText(static_cast<double>(minimum), 6) + " on, got '" +
                                        std::string(text) + "'");
    }
    value = *number;
    return FOREFRONT_OK;
}

forefront_status setOption(forefront_context &context, forefront::MeshingJob &job, const std::string &name,
                           std::string_view value) {
    forefront::MeshingOptions &options = job.options;
    if (name == "elements") {
        return setWord(context, options.elements, "elements", value);
    }
    if (name == "order") {
        return setWord(context, options.order, "order", value);
    }
    if (name == "quad-nodes") {
        return setWord(context, options.quadNodes, "quad-nodes", value);
    }
    if (name == "method") {
        return setWord(context, options.method, "method", value);
    }
    if (name == "grid") {
        return setWord(context, options.grid, "grid", value);
    }
    if (name == "improve") {
        return setWord(context, options.improve, "improve", value);
    }
    if (name == "threads") {
        return setNumber<unsigned>(context, options.threads, "threads", value, 1U);
    }
    if (name == "max-elements") {
        return setNumber<std::uint64_t>(context, options.maxElements, "max-elements", value, 1U);
    }
    if (name == "min-angle") {
        return setNumber<double>(context, options.leastAngle, "min-angle", value, 0.0);
    }
    if (name == "gradation") {
        return setNumber<double>(context, job.spacing.gradation, "gradation", value, 0.0);
    }
    if (name == "elements-across") {
        return setNumber<double>(context, job.spacing.elementsAcross, "elements-across", value, 0.0);
    }
    if (name == "segments-per-turn") {
        return setNumber<double>(context, job.spacing.segmentsPerTurn, "segments-per-turn", value, 0.0);
    }
    if (name == "keep-boundary" && (value == "true" || value == "false")) {
        options.keepBoundary = value == "true";
        return FOREFRONT_OK;
    }
    return badArgument(context, name == "keep-boundary"
                                    ? "keep-boundary: expected true or false, got '" + std::string(value) + "'"
                                    : "unknown option '" + name + "'");
}

} // namespace

forefront_job *forefront_job_new(forefront_context *context) {
    forefront_job *job = nullptr;
    guarded(context, [&] {
        job = new forefront_job;
        return FOREFRONT_OK;
    });
    return job;
}

void forefront_job_free(forefront_job *job) {
    delete job;
}

forefront_status forefront_read_domain(forefront_context *context, forefront_job *job, const char *path,
                                       const char *format) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (path == nullptr) {
            return badArgument(*context, "the path is null");
        }
        forefront::ImportOptions options;
        options.formatId = format == nullptr ? "" : format;
        forefront::Result<forefront::DomainFile> file = forefront::readDomain(std::filesystem::path(path), options);
        if (!file) {
            return report(*context, file.faults());
        }
        to.domain = std::move(file->domain);
        to.spacing = std::move(file->spacing);
        to.cracks = std::move(file->cracks);
        to.periodic = job->periodicOfMesh = std::move(file->periodic);
        to.mapped = std::move(file->mapped);
        to.strips = std::move(file->strips);
        to.layers = std::move(file->layers);
        to.regionElements = std::move(file->regionElements);
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_loop(forefront_context *context, forefront_job *job, const double *corners, size_t count,
                                    int32_t tag) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (corners == nullptr && count > 0) {
            return badArgument(*context, "the corners are null");
        }
        addLoop(to.domain, placesOf(corners, count), tag);
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_line(forefront_context *context, forefront_job *job, const double *places, size_t count,
                                    int32_t tag) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (places == nullptr || count < 2) {
            return badArgument(*context, "expected at least two places of a line");
        }
        const auto first = static_cast<std::uint32_t>(to.domain.nodes.size());
        const std::vector<Vec2> nodes = placesOf(places, count);
        to.domain.nodes.insert(to.domain.nodes.end(), nodes.begin(), nodes.end());
        for (std::uint32_t k = 0; k + 1 < count; ++k) {
            to.domain.segments.push_back({first + k, first + k + 1, tag, forefront::SegmentRole::Constraint});
        }
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_point(forefront_context *context, forefront_job *job, double x, double y, int32_t tag) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.domain.points.push_back({static_cast<std::uint32_t>(to.domain.nodes.size()), tag});
        to.domain.nodes.push_back({x, y});
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_region(forefront_context *context, forefront_job *job, double x, double y, int32_t tag,
                                      double size, double max_area) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.domain.regionMarkers.push_back({{x, y}, tag});
        if (size != 0.0 || max_area != 0.0) {
            to.spacing.placed.regions.push_back({{x, y}, max_area, size});
        }
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_hole(forefront_context *context, forefront_job *job, double x, double y) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.domain.holeMarkers.push_back({x, y});
        to.domain.insideRule = forefront::InsideRule::HoleMarkers;
        return FOREFRONT_OK;
    });
}

forefront_status forefront_name_boundary(forefront_context *context, forefront_job *job, int32_t tag,
                                         const char *name) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.domain.boundaryNames[tag] = name == nullptr ? "" : name;
        return FOREFRONT_OK;
    });
}

forefront_status forefront_name_region(forefront_context *context, forefront_job *job, int32_t tag, const char *name) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.domain.regionNames[tag] = name == nullptr ? "" : name;
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_layers(forefront_context *context, forefront_job *job, int32_t tag, double first,
                                      double growth, uint32_t count, double thickness, const char *elements) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        forefront::LayerSpec spec{tag, first, growth};
        if (count > 0) {
            spec.count = count;
        }
        if (thickness != 0.0) {
            spec.thickness = thickness;
        }
        const forefront_status status =
            elements == nullptr ? FOREFRONT_OK : setWord(*context, spec.cells, "elements", elements);
        if (status == FOREFRONT_OK) {
            to.layers.push_back(spec);
        }
        return status;
    });
}

forefront_status forefront_add_crack(forefront_context *context, forefront_job *job, int32_t tag) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.cracks.push_back(tag);
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_periodic(forefront_context *context, forefront_job *job, int32_t from, int32_t to_tag) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.periodic.push_back({from, to_tag});
        std::erase(job->periodicOfMesh, to.periodic.back());
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_mapped(forefront_context *context, forefront_job *job, int32_t region,
                                      const double *corners, size_t count) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (corners == nullptr && count > 0) {
            return badArgument(*context, "the corners are null");
        }
        to.mapped.push_back({region, placesOf(corners, count)});
        return FOREFRONT_OK;
    });
}

forefront_status forefront_add_strip(forefront_context *context, forefront_job *job, int32_t tag, double width,
                                     uint32_t rows, const char *elements, int32_t region) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        forefront::StripSpec spec{tag, width, rows};
        spec.region = region;
        const forefront_status status =
            elements == nullptr ? FOREFRONT_OK : setWord(*context, spec.cells, "elements", elements);
        if (status == FOREFRONT_OK) {
            to.strips.push_back(spec);
        }
        return status;
    });
}

forefront_status forefront_set_region_elements(forefront_context *context, forefront_job *job, int32_t region,
                                               const char *elements) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (elements == nullptr) {
            return badArgument(*context, "the elements are null");
        }
        forefront::RegionElements own{region};
        const forefront_status status = setWord(*context, own.elements, "elements", elements);
        if (status == FOREFRONT_OK) {
            to.regionElements.push_back(own);
        }
        return status;
    });
}

forefront_status forefront_set_size(forefront_context *context, forefront_job *job, double size) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.spacing.size = size;
        return FOREFRONT_OK;
    });
}

forefront_status forefront_set_expression(forefront_context *context, forefront_job *job, const char *expression) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        if (expression == nullptr) {
            return badArgument(*context, "the expression is null");
        }
        to.spacing.expression = expression;
        return FOREFRONT_OK;
    });
}

forefront_status forefront_set_size_function(forefront_context *context, forefront_job *job,
                                             forefront_size_function function, void *user) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.spacing.bulkFunction = nullptr;
        if (function != nullptr) {
            to.spacing.bulkFunction = [function, user](std::span<const Vec2> places, std::span<double> sizes) {
                static_assert(sizeof(Vec2) == 2 * sizeof(double));
                if (function(places.size(), &places.data()->x, sizes.data(), user) != 0) {
                    throw forefront::c::Cancelled{};
                }
            };
        }
        return FOREFRONT_OK;
    });
}

forefront_status forefront_set_part_size(forefront_context *context, forefront_job *job, int32_t tag, double size,
                                         double growth) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        to.spacing.partSizes[tag] = {size, growth};
        return FOREFRONT_OK;
    });
}

forefront_status forefront_set_option(forefront_context *context, forefront_job *job, const char *name,
                                      const char *value) {
    return changed(context, job, [&](forefront::MeshingJob &to) {
        return name == nullptr || value == nullptr ? badArgument(*context, "the name or the value is null")
                                                   : setOption(*context, to, name, value);
    });
}

forefront_status forefront_set_progress(forefront_context *context, forefront_job *job,
                                        forefront_progress_function function, void *user) {
    return guarded(context, [&] {
        if (job == nullptr) {
            return badArgument(*context, "the job is null");
        }
        job->progress = function;
        job->user = user;
        return FOREFRONT_OK;
    });
}
