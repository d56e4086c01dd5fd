#include "core/teaching/film/film_files.hpp"
#include "ui/dialogs/export_dialog.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr const char *kName = "dialog/film/";

/// The settings that the dialog edits.
struct FilmSettings {
    FilmPlan plan;
    std::optional<double> to; ///< last advance; not set: the end of the run
};

constexpr double kFields = 72.0, kSecond = 290.0; ///< columns, design pixels

/// Draws the label of the second field of a row.
void secondLabel(Workspace &context, const char *text) {
    ImGui::SameLine(context.px(kSecond));
    ui::muted(context, text);
    ImGui::SameLine();
}

constexpr double kMaxAdvance = 1e9;

/// Draws a field for a number within a range.
void numberField(Workspace &context, const char *name, double &value, double minimum, double maximum) {
    const std::string field = std::string(kName) + name;
    double number = value;
    if (ui::inputNumber(context, field, number, 70.0F) && ui::checkRange(context, field, number, minimum, maximum)) {
        value = number;
    }
}

template <class Whole>
void wholeField(Workspace &context, const char *name, Whole &value, double minimum, double maximum) {
    const std::string field = std::string(kName) + name;
    auto number = static_cast<double>(value);
    if (ui::inputNumber(context, field, number, 70.0F) && ui::checkWhole(context, field, number, minimum, maximum)) {
        value = static_cast<Whole>(number);
    }
}

/// Draws the field for the last advance; empty: the end of the run.
void drawEnd(Workspace &context, FilmSettings &settings) {
    const std::string field = std::string(kName) + "to";
    std::optional<double> to = settings.to;
    if (ui::inputOptional(context, field, to, "end", 70.0F) &&
        (!to || ui::checkWhole(context, field, *to, 0.0, kMaxAdvance))) {
        settings.to = to;
    }
}

/// `page`: the output has no frames.
void drawRange(Workspace &context, FilmSettings &settings, bool page) {
    ui::rowLabel(context, "From", kFields);
    wholeField(context, "from", settings.plan.from, 0.0, kMaxAdvance);
    ui::tooltip(context, "Number of advances done at the first frame");
    ImGui::SameLine();
    ui::muted(context, "to");
    ImGui::SameLine();
    drawEnd(context, settings);
    ui::tooltip(context, "Last advance shown; empty: the end of the run");
    if (page) {
        return;
    }
    secondLabel(context, "at most");
    wholeField(context, "frames", settings.plan.frames, 1, FilmPlan::kMaxFrames);
    ImGui::SameLine();
    ui::muted(context, "frames; long runs skip advances");
}

void drawLook(Workspace &context, FilmPlan &plan) {
    ui::rowLabel(context, "Width", kFields);
    wholeField(context, "width", plan.width, FilmPlan::kMinWidth, FilmPlan::kMaxWidth);
    ImGui::SameLine();
    ui::muted(context, "pixels");
    secondLabel(context, "Speed");
    numberField(context, "speed", plan.speed, FilmPlan::kSlowest, FilmPlan::kFastest);
    ImGui::SameLine();
    ui::muted(context, "frames per second (GIF)");
}

void drawLayers(Workspace &context, FilmLayers &layers) {
    constexpr std::array<const char *, wordsOf<FilmLayer>().size()> kLabels{"Mesh", "Boundary", "Front", "Candidates",
                                                                            "Grid", "Caption",  "Labels"};
    ui::rowLabel(context, "Show", kFields);
    for (std::size_t k = 0; k < kLabels.size(); ++k) {
        if (k > 0) {
            ImGui::SameLine(0, context.px(14));
        }
        const std::string name = std::string(kName) + "layer/" + std::string(wordsOf<FilmLayer>()[k]);
        ui::checkbox(context, name, kLabels[k], layers.shown[k]);
    }
}

/// What is written by default to files of a kind.
enum class FilmFrames : std::uint8_t { Together, Numbered, OneMoment };

/// A kind of file that films are exported to.
struct FilmFile {
    const char *id, *name, *extension, *note;
    FilmFrames frames;
};

constexpr std::array<FilmFile, 5> kFilmFiles{
    {{"gif", "Animated GIF (.gif)", ".gif", "Loops; plays in browsers and slides.", FilmFrames::Together},
     {"html", "Page that plays the run (.html)", ".html",
      "Opens in any browser, without a network: play, step, zoom, candidates.", FilmFrames::Together},
     {"png", "PNG frames (.png)", ".png", "One picture per frame: NAME-1.png, NAME-2.png and so on.",
      FilmFrames::Numbered},
     {"svg", "SVG of one moment (.svg)", ".svg",
      "A vector drawing of the first advance; name it NAME-%d.svg for one per frame.", FilmFrames::OneMoment},
     {"pdf", "PDF of one moment (.pdf)", ".pdf",
      "A page with the first advance; name it NAME-%d.pdf for one per frame.", FilmFrames::OneMoment}}};

const FilmFile &filmFile(std::string_view id) {
    return *std::find_if(kFilmFiles.begin(), kFilmFiles.end(), [id](const FilmFile &file) { return id == file.id; });
}

/// Returns the plan for an output file. A GIF or a single moment is one file; other frames are numbered. A reversed
/// range becomes empty.
FilmPlan planFor(const FilmSettings &settings, const std::filesystem::path &file, const FileFilter &filter) {
    FilmPlan plan = settings.plan;
    plan.output = file;
    const FilmFile &kind = filmFile(filter.id);
    const bool moment = kind.frames == FilmFrames::OneMoment && !plan.numbered();
    if (kind.frames == FilmFrames::Numbered && !plan.numbered()) {
        plan.output.replace_filename(file.stem().string() + "-%d" + file.extension().string());
    }
    const auto from = static_cast<double>(plan.from);
    if (moment) {
        plan.steps = 0; // only the start of the range
    } else if (settings.to) {
        plan.steps = static_cast<std::uint64_t>(std::llround(std::max(*settings.to - from, 0.0)));
    }
    return plan;
}

Diagnostics film(Shell &context, const FilmPlan &plan) {
    if (const std::string fault = outputFault(plan); !fault.empty()) {
        return error("bad-output", fault);
    }
    for (int frame = 1; plan.numbered() && frame <= plan.frames; ++frame) {
        if (const std::filesystem::path file = frameName(plan.output, frame); std::filesystem::exists(file)) {
            return error("exists", file.filename().string() + " already exists",
                         "choose another name, or delete the frames of the earlier film");
        }
    }
    const auto frames = std::make_shared<int>(0);
    MeshingJob job = context.run.job();
    const auto write = [plan, frames, job = std::move(job)](const Progress &progress) {
        const Result<WrittenFilm> written = writeFilm(job, plan, progress);
        *frames = written ? written->frames : 0;
        return written ? Diagnostics() : written.faults();
    };
    const auto done = [plan, frames](Shell &c) {
        const std::string what = plan.isPage() ? "Exported page to " + plan.output.string()
                                               : "Exported film to " + plan.output.string() + ": " +
                                                     ui::count(static_cast<unsigned>(*frames)) +
                                                     (*frames == 1 ? " frame" : " frames");
        c.log.announce(what);
    };
    context.dialogs.open(std::make_unique<WriteDialog>(context.background, plan.output.string(), write, done));
    return {};
}

std::vector<FileFilter> filmFilters() {
    std::vector<FileFilter> filters;
    for (const FilmFile &file : kFilmFiles) {
        filters.push_back({file.name, {file.extension}, file.id, file.note});
    }
    return filters;
}

} // namespace

void exportFilm(Shell &context) {
    if (!context.run.steps()) {
        context.log.refuse("Films show a front of triangles; set Elements to Triangles in the panel Meshing");
        return;
    }
    FileRequest request;
    request.id = "film";
    request.title = "Export film";
    request.action = "Export";
    request.saves = true;
    request.filters = filmFilters();
    const std::filesystem::path &document = context.document.path();
    request.folder = document.parent_path();
    request.name = (document.empty() ? context.document.title() : document.stem().string()) + ".gif";
    const auto settings = std::make_shared<FilmSettings>();
    settings->plan.layers.shown[static_cast<std::size_t>(FilmLayer::Grid)] =
        context.layer("grid") != nullptr && context.layer("grid")->visible;
    request.chosen = [settings](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        return film(c, planFor(*settings, file, filter));
    };
    request.extraLines = 3;
    settings->plan.title = document.empty() ? context.document.title() : document.stem().string();
    request.extra = [settings](Shell &c, const FileFilter &filter) {
        const bool page = std::string_view(filter.id) == "html";
        drawRange(c, *settings, page);
        if (!page) {
            drawLook(c, settings->plan);
            drawLayers(c, settings->plan.layers);
        }
        return true;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
