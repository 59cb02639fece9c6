#pragma once

#include "runtime/tick/channels.h"

namespace rob::runtime {

/// Takes what motion reports, in order of time: the events of an instant come before its snapshot.
/// To be called by the one thread that reads these channels.
template <typename TakeEvent, typename TakeSnapshot>
void drain_in_order(Channels& channels, TakeEvent take_event, TakeSnapshot take_snapshot) {
  const motion::MotionEvent* event = nullptr;
  while (const Snapshot* const snapshot = channels.snapshots.front()) {
    while ((event = channels.events.front()) != nullptr &&
           event->time <= snapshot->sample.reference.time) {
      take_event(*event);
      channels.events.pop();
    }
    take_snapshot(*snapshot);
    channels.snapshots.pop();
  }
  while ((event = channels.events.front()) != nullptr) {
    take_event(*event);
    channels.events.pop();
  }
}

}  // namespace rob::runtime
