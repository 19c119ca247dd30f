// JavaScriptCore's C API, of a library that the first call loads (base/late_library.h).
// Tested by tests/generator/script/engine_test.cpp.
#pragma once

#include <JavaScriptCore/JavaScript.h>

#include "base/late_library.h"

// JavaScriptCore exports these and declares them in no header. A callback that returns true ends
// the script with an exception that it cannot catch.
extern "C" {
using JSShouldTerminateCallback = bool (*)(JSContextRef context, void* data);
void JSContextGroupSetExecutionTimeLimit(JSContextGroupRef group, double seconds,
                                         JSShouldTerminateCallback callback, void* data);
}

namespace mjcourse {

#define MJCOURSE_LATE(name) inline const LateFunction<kScriptEngine, decltype(::name)> name(#name)
MJCOURSE_LATE(JSClassCreate);
MJCOURSE_LATE(JSContextGetGlobalObject);
MJCOURSE_LATE(JSContextGroupCreate);
MJCOURSE_LATE(JSContextGroupRelease);
MJCOURSE_LATE(JSContextGroupSetExecutionTimeLimit);
MJCOURSE_LATE(JSEvaluateScript);
MJCOURSE_LATE(JSGlobalContextCreateInGroup);
MJCOURSE_LATE(JSGlobalContextRelease);
MJCOURSE_LATE(JSObjectCallAsFunction);
MJCOURSE_LATE(JSObjectGetPrivate);
MJCOURSE_LATE(JSObjectGetProperty);
MJCOURSE_LATE(JSObjectGetPropertyAtIndex);
MJCOURSE_LATE(JSObjectGetTypedArrayByteOffset);
MJCOURSE_LATE(JSObjectGetTypedArrayBytesPtr);
MJCOURSE_LATE(JSObjectGetTypedArrayLength);
MJCOURSE_LATE(JSObjectMake);
MJCOURSE_LATE(JSObjectMakeArray);
MJCOURSE_LATE(JSObjectMakeError);
MJCOURSE_LATE(JSObjectMakeFunction);
MJCOURSE_LATE(JSObjectMakeTypedArray);
MJCOURSE_LATE(JSObjectMakeTypedArrayWithBytesNoCopy);
MJCOURSE_LATE(JSObjectSetProperty);
MJCOURSE_LATE(JSObjectSetPropertyAtIndex);
MJCOURSE_LATE(JSStringCreateWithUTF8CString);
MJCOURSE_LATE(JSStringGetCharactersPtr);
MJCOURSE_LATE(JSStringGetLength);
MJCOURSE_LATE(JSStringGetMaximumUTF8CStringSize);
MJCOURSE_LATE(JSStringGetUTF8CString);
MJCOURSE_LATE(JSStringRelease);
MJCOURSE_LATE(JSValueGetTypedArrayType);
MJCOURSE_LATE(JSValueIsNumber);
MJCOURSE_LATE(JSValueIsObject);
MJCOURSE_LATE(JSValueIsString);
MJCOURSE_LATE(JSValueMakeNumber);
MJCOURSE_LATE(JSValueMakeString);
MJCOURSE_LATE(JSValueMakeUndefined);
MJCOURSE_LATE(JSValueProtect);
MJCOURSE_LATE(JSValueToBoolean);
MJCOURSE_LATE(JSValueToNumber);
MJCOURSE_LATE(JSValueToObject);
MJCOURSE_LATE(JSValueToStringCopy);
MJCOURSE_LATE(JSValueUnprotect);
#undef MJCOURSE_LATE

}  // namespace mjcourse
