#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "runtime/command/commanded.h"
#include "runtime/words/messages.h"

/// Where effects lie on the way of a motion. Places in m of the tool's way.
namespace rob::runtime {

/// Lays what a motion does on its way onto its segment, once its way is known; or why it cannot be:
/// a place lies beyond the motion, or there are too many.
std::optional<Words> lay_events(Commanded& commanded);

/// Every place along a PATH becomes one on a motion of it; or why not: it lies beyond the path.
std::optional<Words> share_out(std::vector<OnTheWay> events, std::deque<Commanded>& path);

}  // namespace rob::runtime
