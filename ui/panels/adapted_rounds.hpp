#pragma once

#include <cstddef>

namespace forefront {

struct Shell;

/// Fetches the progress of the adaptation, shows each new mesh unless another one was chosen, and logs how it ends.
/// Drops the rounds of a document that is no longer open. Called once per frame; returns true if there is news.
bool followAdaptation(Shell &context);

/// Shows the mesh of a round, coloured by its estimated error, as an opened mesh.
void showRound(Shell &context, std::size_t round);

/// Makes the spacing of a round that of the document, so that the drawing can be meshed the same way again.
void keepSpacing(Shell &context, std::size_t round);

} // namespace forefront
