#include "script/mujoco_functions.h"

#include <mujoco/mujoco.h>

#include <span>
#include <tuple>
#include <type_traits>

#include "physics/simulation.h"
#include "script/js_value.h"
#include "script/native_function.h"

namespace mjcourse {

namespace {

// A call's arguments, taken one by one as the C parameter types ask for them.
struct Arguments {
  JSContextRef context;
  std::span<const JSValueRef> values;
  Simulation& simulation;

  template <typename Parameter>
  Parameter take() {
    if constexpr (std::is_same_v<Parameter, const mjModel*>) {
      return simulation.model().get();
    } else if constexpr (std::is_convertible_v<mjData*, Parameter>) {
      return simulation.data().get();
    } else if constexpr (std::is_pointer_v<Parameter>) {
      return numbers(next());
    } else {
      return static_cast<Parameter>(JSValueToNumber(context, next(), nullptr));
    }
  }

  JSValueRef next() {
    JSValueRef value = values.front();
    values = values.subspan(1);
    return value;
  }

  // A Float64Array's memory, which nothing moves while this call lasts.
  mjtNum* numbers(JSValueRef value) const {
    JSObjectRef array = JSValueToObject(context, value, nullptr);
    auto* bytes = static_cast<std::byte*>(JSObjectGetTypedArrayBytesPtr(context, array, nullptr));
    bytes += JSObjectGetTypedArrayByteOffset(context, array, nullptr);
    return reinterpret_cast<mjtNum*>(bytes);
  }
};

template <typename Result, typename... Parameters>
NativeFunction bind(Simulation& simulation, Result (*function)(Parameters...)) {
  return [&simulation, function](JSContextRef context, std::span<const JSValueRef> values) {
    Arguments arguments{context, values, simulation};
    // braces take the arguments in order
    const std::tuple<Parameters...> taken{arguments.take<Parameters>()...};
    if constexpr (std::is_void_v<Result>) {
      std::apply(function, taken);
      return JSValueMakeUndefined(context);
    } else {
      return JSValueMakeNumber(context, std::apply(function, taken));
    }
  };
}

}  // namespace

JSObjectRef make_mujoco_functions(JSContextRef context, Simulation& simulation) {
  JSObjectRef functions = JSObjectMake(context, nullptr, nullptr);
  const auto add = [&](const char* name, auto* function) {
    set_property(context, functions, name, make_function(context, bind(simulation, function)));
  };
  add("mj_differentiatePos", mj_differentiatePos);
  add("mj_integratePos", mj_integratePos);
  add("mj_objectVelocity", mj_objectVelocity);
  add("mj_energyPos", mj_energyPos);
  add("mj_energyVel", mj_energyVel);
  add("mj_mulM", mj_mulM);
  add("mju_rotVecQuat", mju_rotVecQuat);
  add("mju_negQuat", mju_negQuat);
  add("mju_mulQuat", mju_mulQuat);
  add("mju_quatIntegrate", mju_quatIntegrate);
  add("mju_subQuat", mju_subQuat);
  add("mju_quat2Vel", mju_quat2Vel);
  add("mju_axisAngle2Quat", mju_axisAngle2Quat);
  add("mju_normalize4", mju_normalize4);
  return functions;
}

}  // namespace mjcourse
