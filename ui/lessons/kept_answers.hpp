#pragma once

#include "core/teaching/lesson/answers.hpp"
#include "ui/workspace/view/lesson_room.hpp"

#include <string>

namespace forefront {

struct Shell;

// Answers outlive the program: those to each lesson are in a file of the folder LessonRoom::folder, written after each
// answer. If two windows answer one lesson at once, it holds the answers of both.

/// Returns the answers to a lesson, read at the first call; null: there are none. A damaged file is logged and set
/// aside.
const LearnerAnswers *answersTo(Shell &context, const std::string &id);
/// The same for a lesson whose answers have been looked for.
const LearnerAnswers *knownAnswers(const Shell &context, const std::string &id);
/// Returns how many questions of a lesson were answered and shown.
AnswerCount countKnown(const Shell &context, const std::string &id);
/// Returns the answers to a lesson to add some, which keepAnswers() writes then.
LearnerAnswers &openAnswers(Shell &context, const LessonEntry &entry);
/// Writes the answers to a lesson to its file, with those that another window has written there. A failure is logged.
void keepAnswers(Shell &context, const std::string &id);
/// Forgets the answers to a lesson, with their file.
void dropAnswers(Shell &context, const std::string &id);
/// Returns true if answers belong to this version of the lesson, with these random numbers.
bool belongTo(const LessonAnswers &given, const LessonEntry &entry);

} // namespace forefront
