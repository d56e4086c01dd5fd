#pragma once

#include "ui/dialogs/drawing_cards.hpp"
#include "ui/input/pixels.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

struct Shell;

namespace shell {

/// Returns true while the start page is on the canvas, which then shows no other plates.
bool showsStartPage(const Shell &context);

/// The page on an empty canvas with ways to begin: new, open, trace, import, recent drawings, samples, lessons. It is
/// not modal, and goes when a tool is chosen or there is something to see.
class StartPage {
  public:
    /// Draws the page over the canvas while Plates::start is set.
    void draw(Shell &context, const PixelRect &canvas);

  private:
    void drawContent(Shell &context);
    void drawCards(Shell &context);

    std::unique_ptr<DrawingCards> recent_, samples_; ///< null: not drawn yet
    std::vector<std::string> recentFiles_;           ///< that `recent_` was made for
    std::size_t unsaved_ = 0;                        ///< number of unsaved drawings then
};

} // namespace shell
} // namespace forefront
