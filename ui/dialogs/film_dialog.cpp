#include "core/teaching/film/film_files.hpp"
#include "ui/dialogs/export_dialog.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/film_fields.hpp"
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

constexpr double kSecond = 290.0; ///< second column, design pixels

/// Draws the label of the second field of a row.
void secondLabel(Workspace &context, const char *text) {
    ImGui::SameLine(context.px(kSecond));
    ui::muted(context, text);
    ImGui::SameLine();
}

constexpr double kMaxAdvance = 1e9;

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
    ui::rowLabel(context, "From", film_fields::kFields);
    film_fields::whole(context, std::string(kName) + "from", settings.plan.from, 0.0, kMaxAdvance);
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
    film_fields::whole(context, std::string(kName) + "frames", settings.plan.frames, 1, FilmPlan::kMaxFrames);
    ImGui::SameLine();
    ui::muted(context, "frames; long runs skip advances");
}

void drawLook(Workspace &context, FilmPlan &plan) {
    ui::rowLabel(context, "Width", film_fields::kFields);
    film_fields::whole(context, std::string(kName) + "width", plan.width, FilmPlan::kMinWidth, FilmPlan::kMaxWidth);
    ImGui::SameLine();
    ui::muted(context, "pixels");
    secondLabel(context, "Speed");
    film_fields::number(context, std::string(kName) + "speed", plan.speed, FilmPlan::kSlowest, FilmPlan::kFastest);
    ImGui::SameLine();
    ui::muted(context, "frames per second");
}

void drawView(Workspace &context, FilmPlan &plan) {
    ui::rowLabel(context, "View", film_fields::kFields);
    bool part = plan.view.has_value();
    if (ui::checkbox(context, std::string(kName) + "view", "As on the canvas", part)) {
        plan.view = part ? std::optional(film_fields::canvasBox(context.view)) : std::nullopt;
    }
    ui::tooltip(context, "Show the part of the plane that the canvas shows; else the whole domain");
    ImGui::SameLine(0, context.px(14));
    ui::checkbox(context, std::string(kName) + "follow", "Follow the front", plan.follow);
    ui::tooltip(context, "The view stays close to the base of each advance");
    ImGui::SameLine(0, context.px(14));
    ui::checkbox(context, std::string(kName) + "events", "Every event", plan.events);
    ui::tooltip(context, "Show each event of an advance, not only its end");
}

/// What is written by default to files of a kind.
enum class FilmFrames : std::uint8_t { Together, Numbered, OneMoment };

/// A kind of file that films are exported to.
struct FilmFile {
    const char *id, *name, *extension, *note;
    FilmFrames frames;
};

constexpr std::array<FilmFile, 7> kFilmFiles{
    {{"gif", "Animated GIF (.gif)", ".gif", "Loops; plays in browsers and slides.", FilmFrames::Together},
     {"mp4", "MP4 video (.mp4)", ".mp4", "Plays in presentations; written by the program ffmpeg.",
      FilmFrames::Together},
     {"webm", "WebM video (.webm)", ".webm", "Plays in browsers; written by the program ffmpeg.", FilmFrames::Together},
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
    FileRequest request = film_fields::exportRequest(context, "film", "Export film", ".gif");
    request.filters = filmFilters();
    const auto settings = std::make_shared<FilmSettings>();
    settings->plan.layers.shown[static_cast<std::size_t>(FilmLayer::Grid)] =
        context.layer("grid") != nullptr && context.layer("grid")->visible;
    request.chosen = [settings](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        return film(c, planFor(*settings, file, filter));
    };
    request.extraLines = [](const FileFilter &) { return 5; };
    settings->plan.title = std::filesystem::path(request.name).stem().string();
    request.extra = [settings](Shell &c, const FileFilter &filter) {
        const bool page = std::string_view(filter.id) == "html";
        drawRange(c, *settings, page);
        if (!page) {
            drawLook(c, settings->plan);
            film_fields::layers(c, kName, settings->plan.layers);
            drawView(c, settings->plan);
        }
        return true;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
