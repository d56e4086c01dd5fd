#pragma once

#include "core/teaching/lesson/glossary.hpp"

/// The figures of the glossary; related terms may share one.
namespace forefront::figures {

Figure domain();
Figure spacing();
Figure front();
Figure base();
Figure idealPoint();
Figure candidates();
Figure candidateSegments();
Figure score();
Figure shapeFactor();
Figure conformity();
Figure grid();
Figure neighbours();
Figure rejection();
Figure deferral();
Figure closing();
Figure gradation();
Figure methods();
Figure improvement();
Figure schoenhardt();
Figure adaptation();
Figure strips();

} // namespace forefront::figures
