#include "lang/machine/machine.h"

#include <fmt/format.h>

#include <utility>

#include "lang/text/codes.h"

namespace rob::lang {

Reply Refuser::refuse(Refusal why) {
  refusal_ = std::move(why);
  return Reply::Refused;
}

Reply Refuser::has_no(std::string_view what) {
  return refuse({std::string(code::kMachineWithout), fmt::format("this machine has no {}", what),
                 "run the program on a machine that has it, or leave it out"});
}

Reply Motions::move(int /*line*/, const MoveCommand& /*command*/) { return has_no("MOVE"); }
Reply Motions::via(int /*line*/, const MoveCommand& /*point*/) { return has_no("MOVEC and MOVES"); }
void Motions::work_in(int /*line*/, const Setting& /*setting*/) {}
Reply Motions::begin_path(int /*line*/) { return has_no("PATH"); }
Reply Motions::end_path(int /*line*/) { return has_no("PATH"); }
Reply Motions::on_the_way(int /*line*/, const PathPlace& /*place*/) {
  return has_no("path events");
}
Reply Motions::live_pace(int /*line*/, const Watch& /*pace*/, MoveCommand::Pace /*means*/) {
  return has_no("AT LIVE");
}
Reply Motions::override_speed(int /*line*/, double /*share*/) { return has_no("OVERRIDE"); }
Reply Motions::carry(int /*line*/, const LoadCommand& /*load*/) { return has_no("LOAD"); }
Reply Motions::stop(int /*line*/) { return Reply::Done; }
Reply Motions::brake(int /*line*/) { return has_no("BRAKE"); }
Reply Motions::wait(int /*line*/, double /*seconds*/) { return has_no("WAIT"); }
Reply Motions::end(int /*line*/) { return Reply::Done; }
Reply Motions::forward(int /*line*/, std::span<const double> /*joints*/, PoseValue& /*pose*/) {
  return has_no("kinematics");
}
Reply Motions::inverse(int /*line*/, const PoseValue& /*pose*/, std::span<const double> /*near*/,
                       std::span<double> /*joints*/) {
  return has_no("kinematics");
}

Reply Signals::write_signal(int /*line*/, int /*signal*/, bool /*value*/) {
  return has_no("outputs");
}
Reply Signals::write_analog(int /*line*/, int /*signal*/, double /*volts*/) {
  return has_no("analog outputs");
}
Reply Signals::pulse(int /*line*/, int /*signal*/, double /*seconds*/) { return has_no("PULSE"); }
Reply Signals::read_group(int line, int signal, int count, std::int64_t& value) {
  value = 0;
  for (int i = 0; i < count; ++i) {
    bool bit = false;
    const Reply reply = read_signal(line, signal + i, bit);
    if (reply != Reply::Done) return reply;
    value |= std::int64_t{bit} << i;
  }
  return Reply::Done;
}
Reply Signals::read_signal(int /*line*/, int /*signal*/, bool& /*value*/) {
  return has_no("signals");
}
Reply Signals::read_analog(int /*line*/, int /*signal*/, double& /*volts*/) {
  return has_no("analog signals");
}
Reply Signals::guard(int /*line*/, const Watch& /*condition*/) { return has_no("UNTIL"); }
Reply Signals::ended(int /*line*/, bool& /*hit*/) { return has_no("UNTIL"); }
Reply Signals::when(int /*line*/, const Watch& /*condition*/, int& /*id*/) {
  return has_no("WHEN");
}
Reply Signals::when_raise(const Place& /*place*/, std::string_view /*text*/) {
  return has_no("WHEN");
}
Reply Signals::when_handle(int /*line*/, bool /*stops*/) { return has_no("WHEN"); }
Reply Signals::leave_handler(int /*line*/) { return has_no("WHEN"); }
Reply Signals::disarm(int /*line*/, int /*id*/) { return has_no("WHEN"); }
Reply Signals::stand(int /*line*/, double& /*now*/) { return has_no("WAIT for a condition"); }
bool Signals::taken_as_met(int /*line*/) { return false; }
Reply Signals::waited(int /*line*/) { return Reply::Done; }

Reply Output::print(int /*line*/, std::string_view /*text*/) { return has_no("PRINT"); }

Reply Files::write(int /*line*/, std::string_view /*file*/, std::string_view /*text*/) {
  return has_no("WRITE");
}
Reply Files::persist(int /*line*/, std::size_t /*variable*/, std::string_view /*value*/) {
  return has_no("PERSIST");
}
Reply Files::read_file(int /*line*/, std::string_view /*file*/, std::string& /*text*/) {
  return has_no("READ");
}
void Files::warn(int /*line*/, Refusal /*warning*/) {}
Reply Files::exists(int /*line*/, std::string_view /*file*/, bool& /*value*/) {
  return has_no("EXISTS");
}

Reply Devices::send(int /*line*/, std::size_t /*device*/, std::string_view /*text*/) {
  return has_no("SEND");
}
Reply Devices::receive(int /*line*/, std::size_t /*device*/, double /*timeout*/,
                       std::string& /*text*/, bool& /*came*/) {
  return has_no("RECEIVE");
}
Reply Devices::simulate_line(int /*line*/, std::size_t /*device*/, std::string_view /*text*/,
                             double /*after*/) {
  return has_no("SIMULATE");
}

Reply Operator::halt(int /*line*/, std::string_view /*text*/) { return has_no("HALT"); }
Reply Operator::ask(int /*line*/, std::string_view /*text*/,
                    std::optional<std::string>& /*answer*/) {
  return has_no("ASK");
}
Reply Operator::teach(int /*line*/, TaughtPoint& /*point*/) { return has_no("TEACH"); }

Reply Force::press(int /*line*/, const PressCommand& /*command*/) { return has_no("PRESS"); }
Reply Force::end_press(int /*line*/) { return has_no("PRESS"); }
Reply Force::zero_force(int /*line*/) { return has_no("ZERO force"); }

Reply Testing::expectation_failed(int /*line*/, std::string_view /*text*/) {
  return has_no("EXPECT");
}
Reply Testing::simulate(int /*line*/, int /*signal*/, double /*value*/, double /*after*/) {
  return has_no("SIMULATE");
}
Reply Testing::simulate_force(int /*line*/, int /*component*/, double /*value*/, double /*after*/) {
  return has_no("SIMULATE");
}
Reply Testing::simulate_go(int /*line*/, bool /*go*/, double /*after*/) {
  return has_no("SIMULATE");
}
Reply Testing::simulate_answer(int /*line*/, std::string_view /*text*/, double /*after*/) {
  return has_no("SIMULATE");
}

Reply Shared::start(const Place& /*place*/, std::uint32_t /*task*/) { return has_no("TASKs"); }
Reply Shared::publish(int /*line*/, std::size_t /*first*/, std::span<const Slot> /*values*/) {
  return has_no("TASKs");
}
Reply Shared::publish(int /*line*/, std::size_t /*first*/, std::span<const std::string> /*texts*/) {
  return has_no("TASKs");
}
Reply Shared::publish_list(int /*line*/, std::size_t /*home*/, const ListContent& /*list*/) {
  return has_no("TASKs");
}
Reply Shared::refresh(int /*line*/, std::size_t /*first*/, std::span<Slot> /*values*/) {
  return has_no("TASKs");
}
Reply Shared::refresh(int /*line*/, std::size_t /*first*/, std::span<std::string> /*texts*/) {
  return has_no("TASKs");
}

Reply Machine::read(int /*line*/, Reading what, Slot* /*value*/) { return has_no(name_of(what)); }
Reply Machine::leave_block(int /*line*/) { return Reply::Done; }
Reply Machine::settle(int /*line*/) { return Reply::Done; }

}  // namespace rob::lang
