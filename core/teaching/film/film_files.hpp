#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/teaching/film/film_scene.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace forefront {

/// The content of a film of a run, and its output file.
struct FilmPlan {
    /// .gif, .mp4, .webm: an animation; .html: a page that plays the run; NAME-%d.png, .svg or .pdf: numbered frames;
    /// else one moment.
    std::filesystem::path output;
    std::string title; ///< of a page
    /// Position of the first frame: the number of advances done. After the last advance follow the steps of the
    /// improvement.
    std::uint64_t from = 0;
    std::optional<std::uint64_t> steps; ///< number of advances, and steps, shown; not set: to the end of the run
    int frames = 120;                   ///< maximum number of frames; long runs skip advances and steps
    int width = 800;                    ///< pixels
    double speed = 10.0;                ///< frames per second of an animation
    FilmLayers layers;
    std::optional<Box2> view; ///< part of the plane shown; not set: the whole domain
    bool follow = false;      ///< the view follows the base of the advance, which takes a tenth of the width
    bool events = false;      ///< steps by the events of the advances; else by whole advances

    static constexpr int kMaxFrames = 5000, kMinWidth = 100, kMaxWidth = 4000;
    static constexpr double kSlowest = 0.1, kFastest = 50.0;
    static constexpr std::uint64_t kMaxEventAdvances = 20'000; ///< of a film that steps by events

    /// Returns true if the output is a page, which has no frames, layers, width, speed or view.
    bool isPage() const { return output.extension() == ".html"; }
    bool isAnimation() const;
    /// Returns true if each frame is a file of its own.
    bool numbered() const { return output.filename().string().find("%d") != std::string::npos; }
};

/// Returns the bytes of a scene in the format of an output: .png, .pdf, or else SVG.
std::string pictureOf(const std::filesystem::path &output, const FilmScene &scene);

/// Returns a part of the plane widened so that no picture is much taller than wide.
Box2 sheetBox(Box2 box);

/// Returns the name of a frame, counted from 1; `pattern` contains %d.
std::filesystem::path frameName(const std::filesystem::path &pattern, int frame);

/// Returns the error in the name of the output; empty if there is none.
std::string outputFault(const FilmPlan &plan);

/// The extent of a written film.
struct WrittenFilm {
    int frames = 0;                    ///< 0: a page
    std::uint64_t first = 0, last = 0; ///< positions at its start and end; of a page: numbers of advances
    std::uint64_t advances = 0;        ///< of the run, as far as it was made
    bool labelled = false;             ///< at least one frame has labels of an advance
};

/// Runs a job and writes its film, reporting progress by frame. The film is shorter than the plan if the run ends
/// before. A film of a whole run ends with the improvement, which has at least a quarter of the frames if it has so
/// many steps. Faults: those of the job, bad-range (the run ends before the film begins, or has too many advances to be
/// shown by events), too-large (of a page), no-encoder (of a video), cannot-write, cancelled, out-of-memory.
Result<WrittenFilm> writeFilm(MeshingJob job, const FilmPlan &plan, const Progress &progress = {});

} // namespace forefront
