#include "core/teaching/film/film_files.hpp"

#include "core/engine/session/mesh_stepper.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/files/text/file_set.hpp"
#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/gif_writer.hpp"
#include "core/teaching/film/pdf_writer.hpp"
#include "core/teaching/film/png_writer.hpp"
#include "core/teaching/page/run_page.hpp"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Widens a tall box on both sides, so that no film is much taller than wide.
Box2 shownBox(Box2 box) {
    constexpr double kTallest = 1.5; // height over width
    const double missing = box.size().y / kTallest - box.size().x;
    if (missing > 0.0) {
        box.min.x -= 0.5 * missing;
        box.max.x += 0.5 * missing;
    }
    return box;
}

/// Writes the frames of a run.
class Filming {
  public:
    Filming(const FilmPlan &plan, const Progress &progress, MeshStepper stepper)
        : plan_(plan), progress_(progress), stepper_(std::move(stepper)) {}

    Status film() {
        sheet_.box = shownBox(stepper_.mesh().bounds());
        sheet_.width = plan_.width;
        if (!stepper_.finish(quiet())) {
            return cancelled();
        }
        const std::uint64_t end = stepper_.known();
        if (plan_.from > end) {
            return error("bad-range", "the film begins after advance " + std::to_string(plan_.from) +
                                          ", but the run has only " + std::to_string(end) + " advances");
        }
        from_ = plan_.from;
        last_ = std::min(end, plan_.steps ? from_ + std::min(*plan_.steps, end) : end);
        return plan_.output.extension() == ".gif" ? writeGif() : plan_.numbered() ? writeSequence() : writeMoment();
    }
    WrittenFilm written() const { return {written_, from_, last_, labelled_}; }

    static Status cancelled() { return error("cancelled", "the film was cancelled"); }

  private:
    /// Returns a progress that only stops: the film reports its frames.
    Progress quiet() const { return {{}, progress_.stop}; }

    /// Calls write(scene, number) for each frame, numbered from 1, until it fails.
    template <class Write>
    Status forFrames(Write write) {
        const std::uint64_t steps = last_ - from_;
        const auto frames = static_cast<int>(std::min(steps + 1, static_cast<std::uint64_t>(plan_.frames)));
        for (int k = 0; k < frames; ++k) {
            const std::uint64_t at =
                frames == 1 ? last_
                            : from_ + steps * static_cast<std::uint64_t>(k) / static_cast<std::uint64_t>(frames - 1);
            const FilmScene scene = sceneAt(at);
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
        const FilmScene scene = sceneAt(last_);
        if (progress_.cancelled()) {
            return cancelled();
        }
        written_ = 1;
        return writeFileAtomically(plan_.output, pictureOf(plan_.output, scene));
    }
    /// Returns the bytes of a frame in the format of an output.
    static std::string pictureOf(const std::filesystem::path &output, const FilmScene &scene) {
        return output.extension() == ".png"   ? pngOf(paintScene(scene))
               : output.extension() == ".pdf" ? pdfOf(scene)
                                              : svgOf(scene);
    }

    FilmScene sceneAt(std::uint64_t advance) {
        stepper_.seek(advance, quiet());
        FilmScene scene = sceneOf(*stepper_.snapshot(plan_.layers.needed()), sheet_, plan_.layers, last_);
        labelled_ = labelled_ || std::any_of(scene.texts.begin(), scene.texts.end(),
                                             [](const FilmText &text) { return text.place.has_value(); });
        return scene;
    }

    const FilmPlan &plan_;
    const Progress &progress_;
    FilmSheet sheet_;
    std::uint64_t from_ = 0, last_ = 0; ///< the first and last advance of the film
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
    return WrittenFilm{0, 0, written->advances, false};
}

} // namespace

std::filesystem::path frameName(const std::filesystem::path &pattern, int frame) {
    std::string name = pattern.filename().string();
    name.replace(name.find("%d"), 2, std::to_string(frame));
    return pattern.parent_path() / name;
}

std::string outputFault(const FilmPlan &plan) {
    const std::string extension = plan.output.extension().string();
    if (extension != ".gif" && extension != ".html" && extension != ".png" && extension != ".svg" &&
        extension != ".pdf") {
        return "unknown extension '" + extension + "'; expected .gif, .html, .png, .svg or .pdf";
    }
    if (plan.isPage() && plan.numbered()) {
        return "a page holds the whole run; leave out %d";
    }
    if (extension == ".gif" && plan.numbered()) {
        return "a GIF holds all frames; leave out %d";
    }
    return {};
}

Result<WrittenFilm> writeFilm(MeshingJob job, const FilmPlan &plan, const Progress &progress) {
    try {
        if (plan.isPage()) {
            return writePage(job, plan, progress);
        }
        job.options.order = ElementOrder::First; // a film shows the triangles as the front made them
        Result<MeshStepper> stepper = MeshStepper::create(std::move(job), {{}, progress.stop});
        if (!stepper) {
            return progress.cancelled() ? Filming::cancelled() : stepper.faults();
        }
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
