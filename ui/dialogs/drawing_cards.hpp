#pragma once

#include "ui/dialogs/thumbnails.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

struct Shell;

/// Drawings to choose from, each with a picture of its mesh, which is made in the background.
class DrawingCards {
  public:
    struct Card {
        std::string title;
        std::string about;
        std::filesystem::path path; ///< of a project, or of what keeps an unsaved one
        std::string text = {};      ///< of an unsaved project; empty: it is read from the path
    };
    DrawingCards(BackgroundList &list, std::vector<Card> cards);

    /// Draws the cards in rows, each as the widget PREFIX and the name of its file. Returns the one that was clicked.
    /// `columns`: of small cards, without the text about them; 0: as many cards with text as fit.
    std::optional<std::size_t> draw(Shell &context, const std::string &prefix, std::size_t columns = 0);
    const std::vector<Card> &all() const { return cards_; }

  private:
    /// Returns true if the card was clicked. `width` in pixels.
    bool drawCard(Shell &context, std::size_t index, const std::string &name, float width, bool small);

    std::vector<Card> cards_;
    Thumbnails thumbnails_;
};

/// Returns the cards of the samples.
std::vector<DrawingCards::Card> sampleCards();

} // namespace forefront
