#include "core/teaching/film/film_files.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/files/text/file_set.hpp"
#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/gif_writer.hpp"
#include "core/teaching/film/pdf_writer.hpp"
#include "core/teaching/film/png_writer.hpp"
#include "core/teaching/film/video_writer.hpp"
#include "core/teaching/moment/moment.hpp"
#include "core/teaching/page/run_page.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Writes the frames of a run.
class Filming {
  public:
    Filming(const FilmPlan &plan, const Progress &progress, MeshStepper stepper)
        : plan_(plan), progress_(progress), stepper_(std::move(stepper)) {}

    Status film() {
        home_ = sheetBox(plan_.view.value_or(stepper_.mesh().bounds()));
        sheet_.box = home_;
        sheet_.width = plan_.width;
        sheet_.cut = plan_.view || plan_.follow;
        sheet_.legend = plan_.layers.has(FilmLayer::Labels);
        if (!stepper_.finish(quiet())) {
            return cancelled();
        }
        front_ = stepper_.known();
        const std::uint64_t steps = stepper_.snapshot({.mesh = false, .front = false})->improveSteps;
        const std::uint64_t end = front_ + steps;
        if (plan_.from > end) {
            return error("bad-range",
                         "the film begins after advance " + std::to_string(plan_.from) + ", but the run has only " +
                             countText(front_, "advance") +
                             (steps > 0 ? " and " + countText(steps, "step") + " of the improvement" : std::string()));
        }
        from_ = plan_.from;
        last_ = std::min(end, plan_.steps ? from_ + std::min(*plan_.steps, end) : end);
        if (plan_.events && last_ - from_ > FilmPlan::kMaxEventAdvances) {
            return error("bad-range",
                         std::to_string(last_ - from_) + " advances are too many to be shown event by event",
                         "choose at most " + std::to_string(FilmPlan::kMaxEventAdvances) + " of them");
        }
        return isVideo(plan_.output) ? writeVideo()
               : plan_.isAnimation() ? writeGif()
               : plan_.numbered()    ? writeSequence()
                                     : writeMoment();
    }
    WrittenFilm written() const { return {written_, from_, last_, front_, labelled_}; }

    static Status cancelled() { return error("cancelled", "the film was cancelled"); }

  private:
    /// Returns a progress that only stops: the film reports its frames.
    Progress quiet() const { return {{}, progress_.stop}; }

    /// Calls write(scene, number) for each frame, numbered from 1, until it fails.
    template <class Write>
    Status forFrames(Write write) {
        const FramePlaces places = placesOf(plan_.events ? countEvents() : last_ - from_);
        const auto frames = static_cast<int>(places.size());
        for (int k = 0; k < frames; ++k) {
            moveTo(places[static_cast<std::size_t>(k)]);
            const FilmScene scene = sceneHere(last_);
            if (progress_.cancelled()) {
                return cancelled();
            }
            if (Status status = write(scene, k + 1); !status.empty()) {
                return status;
            }
            ++written_;
            progress_("filming", static_cast<double>(k + 1) / frames);
        }
        return {};
    }

    Status writeGif() {
        const int delay = std::max(2, static_cast<int>(100.0 / plan_.speed + 0.5));
        AtomicFile file(plan_.output);
        GifWriter gif(file, sheet_.width, sheet_.height(), delay);
        Status status = forFrames([&](const FilmScene &scene, int) {
            return gif.add(paintScene(scene)) ? Status() : file.commit(); // returns the write error
        });
        if (!status.empty()) {
            return status;
        }
        gif.finish();
        return file.commit();
    }
    Status writeVideo() {
        Result<VideoWriter> video = VideoWriter::open(plan_.output, sheet_.width, sheet_.height(), plan_.speed);
        if (!video) {
            return video.faults();
        }
        const Status status = forFrames(
            [&](const FilmScene &scene, int) { return video->add(paintScene(scene)) ? Status() : video->finish(); });
        return status.empty() ? video->finish() : status;
    }
    /// Writes the frames as a set, so that those of an earlier film never mix with new ones.
    Status writeSequence() {
        FileSet files;
        Status status = forFrames([&](const FilmScene &scene, int number) {
            files.write(frameName(plan_.output, number), pictureOf(plan_.output, scene));
            return files.status();
        });
        return status.empty() ? files.commit() : status;
    }
    Status writeMoment() {
        stepper_.seek(last_, quiet());
        makeRoomForSearch();
        const FilmScene scene = sceneHere({});
        if (progress_.cancelled()) {
            return cancelled();
        }
        written_ = 1;
        return writeFileAtomically(plan_.output, pictureOf(plan_.output, scene));
    }
    /// Widens the sheet of a single moment so that the circle of its search is whole, unless the view is given.
    void makeRoomForSearch() {
        if (sheet_.cut || !sheet_.legend) {
            return;
        }
        const std::shared_ptr<const SessionSnapshot> here =
            stepper_.snapshot({.mesh = false, .front = false, .cells = false, .explanation = true});
        if (const Moment moment = momentOf(*here)) {
            const Vec2 c = moment.advance->ideal, reach{moment.advance->searchRadius, moment.advance->searchRadius};
            sheet_.box.add(c - reach);
            sheet_.box.add(c + reach);
            sheet_.box = sheetBox(sheet_.box);
        }
    }
    using FramePlaces = std::vector<std::uint64_t>;

    /// Returns the steps after the first frame at which frames are drawn, `count` of them at most. Those of the
    /// improvement get at least a quarter of the frames: they are few and each of them shows much.
    FramePlaces placesOf(std::uint64_t count) const {
        const std::uint64_t improving = last_ - std::min(std::max(front_, from_), last_), advancing = count - improving;
        const auto room = static_cast<std::uint64_t>(plan_.frames - 1); // without the first frame
        const std::uint64_t share =
            std::max<std::uint64_t>(room / 4, std::min<std::uint64_t>(room, 1)); // the end, at least
        const std::uint64_t later = std::min(improving, std::max(share, room - std::min(room, advancing)));
        const std::uint64_t sooner = std::min(advancing, room - later);
        FramePlaces places{0};
        for (std::uint64_t k = 1; k <= sooner; ++k) {
            places.push_back(advancing * k / sooner);
        }
        for (std::uint64_t k = 1; k <= later; ++k) {
            places.push_back(advancing + improving * k / later);
        }
        if (plan_.frames == 1) {
            places.front() = count;
        }
        return places;
    }
    /// Returns the number of events from the first to the last advance, and of the steps of the improvement after them;
    /// 0 if it was cancelled.
    std::uint64_t countEvents() {
        stepper_.seek(from_, quiet());
        std::uint64_t count = last_ - std::min(std::max(front_, from_), last_);
        while (stepper_.position() < std::min(last_, front_)) {
            if (progress_.cancelled()) {
                return 0;
            }
            stepper_.step(Granularity::Event, 1);
            ++count;
        }
        stepper_.seek(from_, quiet());
        return count;
    }
    /// Moves to a number of steps after the first advance; it only grows.
    void moveTo(std::uint64_t step) {
        if (plan_.events) {
            stepper_.step(Granularity::Event, static_cast<std::int64_t>(step - step_));
            step_ = step;
        } else {
            stepper_.seek(from_ + step, quiet());
        }
    }
    FilmScene sceneHere(std::optional<std::uint64_t> last) {
        SnapshotLayers needed = plan_.layers.needed();
        needed.explanation = needed.explanation || plan_.follow;
        const std::shared_ptr<const SessionSnapshot> moment = stepper_.snapshot(needed);
        if (plan_.follow) {
            sheet_.box = followed(momentOf(*moment));
        }
        FilmScene scene = sceneOf(*moment, sheet_, plan_.layers, last);
        labelled_ = labelled_ || std::any_of(scene.texts.begin(), scene.texts.end(),
                                             [](const FilmText &text) { return text.place.has_value(); });
        return scene;
    }
    /// Returns the part of the plane around a base, with the proportions of the part shown at first, which is shown
    /// again where there is no advance. Each frame goes a part of the way, so that the view glides.
    Box2 followed(const Moment &moment) {
        constexpr double kBases = 10.0, kGlide = 0.4; // width in bases; part of the way that a frame goes
        if (!moment) {
            followed_.reset();
            return home_;
        }
        const Vec2 a = moment.advance->a, b = moment.advance->b;
        const double width = std::min(kBases * distance(a, b), home_.size().x);
        const Vec2 half = (0.5 * width / home_.size().x) * home_.size();
        const Box2 target{midpoint(a, b) - half, midpoint(a, b) + half};
        const Box2 before = followed_.value_or(target);
        followed_ =
            Box2{before.min + kGlide * (target.min - before.min), before.max + kGlide * (target.max - before.max)};
        return *followed_;
    }

    const FilmPlan &plan_;
    const Progress &progress_;
    FilmSheet sheet_;
    Box2 home_;                         ///< the part of the plane shown at first
    std::optional<Box2> followed_;      ///< the part shown last, while it follows the base
    std::uint64_t step_ = 0;            ///< events since the first advance, in a film that steps by events
    std::uint64_t from_ = 0, last_ = 0; ///< the first and last position of the film
    std::uint64_t front_ = 0;           ///< advances of the run; after them, its improvement
    int written_ = 0;
    bool labelled_ = false;
    MeshStepper stepper_;
};

Result<WrittenFilm> writePage(const MeshingJob &job, const FilmPlan &plan, const Progress &progress) {
    AtomicFile file(plan.output);
    TextWriter out(file);
    const RunPagePlan page{plan.title.empty() ? plan.output.stem().string() : plan.title, plan.from, plan.steps};
    const Result<WrittenRunPage> written = writeRunPage(job, page, out, {{}, progress.stop});
    if (!written) {
        return written.faults();
    }
    out.flush();
    if (Status status = file.commit(); !status.empty()) {
        return status;
    }
    return WrittenFilm{0, 0, written->advances, written->advances, false};
}

} // namespace

std::string pictureOf(const std::filesystem::path &output, const FilmScene &scene) {
    return output.extension() == ".png"   ? pngOf(paintScene(scene))
           : output.extension() == ".pdf" ? pdfOf(scene)
                                          : svgOf(scene);
}

Box2 sheetBox(Box2 box) {
    constexpr double kTallest = 1.5; // height over width
    const double missing = box.size().y / kTallest - box.size().x;
    if (missing > 0.0) {
        box.min.x -= 0.5 * missing;
        box.max.x += 0.5 * missing;
    }
    return box;
}

std::filesystem::path frameName(const std::filesystem::path &pattern, int frame) {
    std::string name = pattern.filename().string();
    name.replace(name.find("%d"), 2, std::to_string(frame));
    return pattern.parent_path() / name;
}

bool FilmPlan::isAnimation() const {
    return output.extension() == ".gif" || isVideo(output);
}

std::string outputFault(const FilmPlan &plan) {
    const std::string extension = plan.output.extension().string();
    if (!plan.isAnimation() && extension != ".html" && extension != ".png" && extension != ".svg" &&
        extension != ".pdf") {
        return "unknown extension '" + extension + "'; expected .gif, .mp4, .webm, .html, .png, .svg or .pdf";
    }
    if (plan.isPage() && plan.numbered()) {
        return "a page holds the whole run; leave out %d";
    }
    if (plan.isAnimation() && plan.numbered()) {
        return "an animation holds all frames; leave out %d";
    }
    return {};
}

Result<WrittenFilm> writeFilm(MeshingJob job, const FilmPlan &plan, const Progress &progress) {
    try {
        if (plan.isPage()) {
            return writePage(job, plan, progress);
        }
        job.options.order = ElementOrder::First; // a film shows corners alone
        Result<MeshStepper> stepper = MeshStepper::create(std::move(job), {{}, progress.stop});
        if (!stepper) {
            return progress.cancelled() ? Filming::cancelled() : stepper.faults();
        }
        stepper->stepImprovement();
        Filming filming(plan, progress, *std::move(stepper));
        if (Status status = filming.film(); !status.empty()) {
            return status;
        }
        return filming.written();
    } catch (const std::bad_alloc &) {
        return error("out-of-memory", "not enough memory for this film", "choose a smaller width");
    }
}

} // namespace forefront
