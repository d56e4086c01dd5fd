#pragma once

#include <string>

namespace forefront {

struct Shell;

// The answers of a learner to the open lesson, and its random numbers.

/// Records an answer to the question of the page.
void recordAnswer(Shell &context, std::string text, bool right);
/// Returns true if a question of the open lesson was answered since the program started.
bool hasAnswersToSave(const Shell &context);
/// Asks for a file and writes the answers to the open lesson.
void saveAnswers(Shell &context);
/// Reads the open lesson again with other random numbers, and shows the same page. Its answers are forgotten.
void chooseOtherNumbers(Shell &context);

} // namespace forefront
