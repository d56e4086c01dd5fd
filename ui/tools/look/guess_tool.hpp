#pragma once

#include "core/teaching/lesson/guess.hpp"
#include "ui/parts/tool.hpp"

#include <cstdint>
#include <string>

namespace forefront {

/// Lets a learner guess the apex of the next element: each click is a guess, which is scored and explained; the
/// following click moves to the next base.
class GuessTool final : public Tool {
  public:
    const char *id() const override { return "guess"; }
    const char *name() const override { return "Guess the next node"; }
    const char *icon() const override;
    int key() const override { return 'Q'; }
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    void activate(Shell &context) override;
    void deactivate(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::vector<ContextGroup> menu(Shell &context, Vec2 place) override;
    std::string statusText(const Shell &context) const override;

  private:
    /// Returns true if the base is shown and its candidates are not.
    static bool asks(const Shell &context);
    /// Returns true if the review belongs to the advance shown.
    bool reviewed(const Shell &context) const;
    void guess(Vec2 place, Shell &context);
    static void nextBase(Shell &context);
    void startAgain();

    GuessReview review_;
    Vec2 place_;                          ///< of the last guess
    std::uint64_t run_ = 0, advance_ = 0; ///< that it belongs to
    int guesses_ = 0, points_ = 0;
    bool followed_ = false;      ///< the camera followed the front when the tool was chosen
    std::uint64_t endedRun_ = 0; ///< whose end was shown when the tool was chosen, and is shown again; 0: none
};

} // namespace forefront
