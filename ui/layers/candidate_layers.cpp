#include "core/teaching/moment/candidate_sides.hpp"
#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/advance_labels.hpp"
#include "ui/layers/layers.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/candidate_text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMaxRanks = 7;

/// Returns the length of the base segment on the screen, in design pixels: a measure of the room for labels.
double roomOf(const LayerFrame &frame, const AdvanceExplanation &advance) {
    return frame.camera.zoom * distance(advance.a, advance.b) / frame.roomScale;
}

Colour verdictColour(const Theme &theme, Verdict verdict, bool judged) {
    if (!judged || verdict == Verdict::NotTried) {
        return theme.candidate;
    }
    return verdict == Verdict::Accepted ? theme.accepted : theme.bad;
}

/// Draws a candidate so that its shape alone tells its verdict: a disc with a tick is accepted, a ring with a cross
/// rejected, an empty ring not tested.
void drawCandidate(CanvasPainter &painter, const Theme &theme, Vec2 at, Verdict verdict, bool judged, double opacity) {
    constexpr double kRadius = 6.5;
    const Colour colour = fade(verdictColour(theme, verdict, judged), opacity);
    const bool tested = judged && verdict != Verdict::NotTried;
    if (tested && verdict == Verdict::Accepted) {
        painter.dot(at, kRadius + 1.0, colour);
        painter.tick(at, kRadius, fade(theme.canvas, opacity), 1.75);
        return;
    }
    painter.dot(at, kRadius, fade(theme.domain, 0.85 * opacity));
    painter.ring(at, kRadius, colour, 1.75);
    if (tested) {
        painter.cross(at, 0.45 * kRadius, colour, 1.5);
    }
}

std::string candidateLabel(const CandidateTrace &candidate, std::size_t rank, const Moment &moment) {
    std::string text = std::to_string(rank + 1);
    if (candidate.square != SquareKind::None) {
        text += std::string("  ") + squareText(candidate.square);
    } else if (moment.scoresKnown) {
        text += ui::format("  score %.*f", scoreDigits(*moment.advance), candidate.score);
    }
    if (moment.judged[rank] && candidate.verdict != Verdict::NotTried) {
        text += std::string("  ") + verdictText(candidate.verdict);
    }
    return text;
}

class CandidatesLayer final : public Layer {
  public:
    const char *id() const override { return "candidates"; }
    const char *name() const override { return "Candidates"; }
    void request(SnapshotLayers &layers) const override { layers.explanation = true; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const Moment moment = momentOf(frame.snapshot);
        if (!moment || roomOf(frame, *moment.advance) < 9.0) {
            return;
        }
        const AdvanceExplanation &e = *moment.advance;
        const Theme &theme = frame.theme;
        if (moment.updated) {
            for (const auto &[p, q, r] : e.made) {
                painter.triangle(p, q, r, fade(theme.accepted, 0.2 + 0.35 * frame.fresh));
            }
            for (const PlacedSide &side : newSidesOf(e)) {
                painter.line(side[0], side[1], theme.accepted, 2.0);
            }
        }
        if (moment.idealKnown && !moment.updated) {
            painter.dashedCircle(e.ideal, e.searchRadius, fade(theme.candidate, 0.55), 1.25);
        }
        if (moment.candidatesKnown) {
            drawNodes(painter, frame, moment);
        }
        if (moment.idealKnown) {
            painter.cross(e.ideal, 4.5, theme.base, 1.75);
            if (roomOf(frame, e) > kLabelledBase) {
                labelOfAdvance(painter, frame, moment, {e.ideal, e.ideal - midpoint(e.a, e.b), "C", theme.base});
            }
        }
    }

  private:
    static void drawNodes(CanvasPainter &painter, const LayerFrame &frame, const Moment &moment) {
        const AdvanceExplanation &e = *moment.advance;
        const Theme &theme = frame.theme;
        const bool words = roomOf(frame, e) > 46.0;
        const auto accepted = [&](std::size_t i) {
            return moment.judged[i] && e.candidates[i].verdict == Verdict::Accepted;
        };
        std::vector<std::size_t> order; // the best on top, and the accepted one, which may lie on another, above all
        for (std::size_t i = moment.candidates; i-- > 0;) {
            order.push_back(i);
        }
        std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !accepted(i); });
        for (const std::size_t i : order) {
            const CandidateTrace &candidate = e.candidates[i];
            const double opacity = frame.candidate && frame.candidate != i ? 0.45 : 1.0;
            drawCandidate(painter, theme, candidate.position, candidate.verdict, moment.judged[i], opacity);
            if (candidate.square == SquareKind::Opening) {
                drawCandidate(painter, theme, candidate.second, candidate.verdict, moment.judged[i], opacity);
            }
        }
        if (frame.candidate) {
            drawChosen(painter, frame, moment, *frame.candidate);
            return;
        }
        for (std::size_t i = 0; words && i < moment.candidates; ++i) {
            painter.reserve(e.candidates[i].position, 5.0); // no label covers a candidate
        }
        const std::size_t labelled = words ? std::min(moment.candidates, kMaxRanks) : 0;
        for (std::size_t i = 0; i < labelled; ++i) {
            const CandidateTrace &candidate = e.candidates[i];
            const Colour colour = verdictColour(theme, candidate.verdict, moment.judged[i]);
            labelOfAdvance(
                painter, frame, moment,
                {candidate.position, {1.0, 0.0}, candidateLabel(candidate, i, moment), colour, /*optional=*/true});
        }
    }

    /// Draws a candidate chosen in the table with its score worked out.
    static void drawChosen(CanvasPainter &painter, const LayerFrame &frame, const Moment &moment, std::size_t i) {
        const CandidateTrace &c = moment.advance->candidates[i];
        const Theme &theme = frame.theme;
        const Colour colour = verdictColour(theme, c.verdict, moment.judged[i]);
        painter.ring(c.position, 10.5, colour, 2.0);
        if (moment.judged[i] && c.verdict == Verdict::Withdrawn && c.blocked) {
            painter.dashedCircle(c.position, c.blockClearance, theme.bad, 1.25);
        }
        std::string text = std::to_string(i + 1);
        if (moment.scoresKnown) {
            text += ui::format("  \xce\xb1 %.3f \xc2\xb7 \xce\xb4 %.2f \xc2\xb7 \xce\xb4 %.2f = %.3f", c.alpha,
                               c.deltaAC, c.deltaCB, c.score);
        }
        painter.freeLabel(c.position, {14.0, -7.0}, text, colour, labelPlate(theme), frame.fonts.small);
    }
};

class TestsLayer final : public Layer {
  public:
    const char *id() const override { return "tests"; }
    const char *name() const override { return "Tests"; }
    void request(SnapshotLayers &layers) const override { layers.explanation = true; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const Moment moment = momentOf(frame.snapshot);
        if (!moment || roomOf(frame, *moment.advance) < 9.0) {
            return;
        }
        const AdvanceExplanation &e = *moment.advance;
        const Theme &theme = frame.theme;
        const auto hidden = [&](std::size_t candidate) { return frame.candidate && *frame.candidate != candidate; };
        for (std::size_t i = 0; i < moment.tests; ++i) {
            const TestTrace &test = e.tests[i];
            if (hidden(test.candidate)) {
                continue;
            }
            painter.line(test.frontA, test.frontB, test.meets ? theme.bad : fade(theme.visited, 0.9),
                         test.meets ? 3.5 : 2.5);
        }
        for (std::size_t i = moment.candidates; i-- > 0;) {
            const CandidateTrace &candidate = e.candidates[i];
            const bool tried = moment.judged[i] && candidate.verdict != Verdict::NotTried;
            const bool trying = !moment.updated && beingTested(moment, i);
            const bool chosen = frame.candidate == i;
            if (hidden(i) || !(tried || trying || chosen)) {
                continue;
            }
            const Colour colour = trying ? theme.candidate : verdictColour(theme, candidate.verdict, true);
            const bool accepted = tried && candidate.verdict == Verdict::Accepted;
            if (!accepted || !moment.updated || chosen) {
                for (const PlacedSide &side : sidesOf(e, candidate)) {
                    painter.dashed(side[0], side[1], fade(colour, chosen ? 1.0 : 0.8), chosen ? 2.5 : 1.5, 5.0);
                }
            }
            if (tried && candidate.blocked) {
                painter.line(candidate.blockA, candidate.blockB, theme.bad, 3.5);
                if (candidate.blockA == candidate.blockB) {
                    painter.ring(candidate.blockA, 7.0, theme.bad, 2.5);
                }
            }
        }
    }

  private:
    static bool beingTested(const Moment &moment, std::size_t candidate) {
        const auto &events = moment.advance->events;
        return moment.cursor < events.size() && events[moment.cursor].step == Step::Test &&
               events[moment.cursor].candidate == candidate;
    }
};

} // namespace

std::unique_ptr<Layer> makeCandidatesLayer() {
    return std::make_unique<CandidatesLayer>();
}

std::unique_ptr<Layer> makeTestsLayer() {
    return std::make_unique<TestsLayer>();
}

} // namespace forefront
