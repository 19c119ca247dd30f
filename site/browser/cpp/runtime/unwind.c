/* Throwing and catching with wasm's own exceptions, for the C++ library's half of it
 * (cxa_exception.cpp): the level-1 interface of the Itanium C++ ABI, "Exception Handling", as
 * clang's code for catch clauses calls it. An exception is a wasm exception of the tag
 * __cpp_exception that carries the address of its _Unwind_Exception. */
#include <stdint.h>
#include <unwind.h>

_Unwind_Reason_Code __gxx_personality_wasm0(int version, _Unwind_Action actions,
                                            uint64_t exception_class,
                                            struct _Unwind_Exception* exception,
                                            struct _Unwind_Context* context);

/* Where clang's code for a catch says which one it is, and where the selector is put for it. */
struct LandingPad {
  __UINTPTR_TYPE__ index, lsda, selector;
};
struct LandingPad __wasm_lpad_context;

_Unwind_Reason_Code _Unwind_CallPersonality(void* thrown) {
  struct _Unwind_Exception* exception = thrown;
  __wasm_lpad_context.selector = 0;
  return __gxx_personality_wasm0(1, _UA_CLEANUP_PHASE, exception->exception_class, exception,
                                 (struct _Unwind_Context*)&__wasm_lpad_context);
}

/* The page remembers where it was. */
void mjc_throws(void);

_Unwind_Reason_Code _Unwind_RaiseException(struct _Unwind_Exception* exception) {
  mjc_throws();
  __builtin_wasm_throw(0, exception);
}

void _Unwind_DeleteException(struct _Unwind_Exception* exception) {
  if (exception->exception_cleanup != 0) {
    exception->exception_cleanup(_URC_FOREIGN_EXCEPTION_CAUGHT, exception);
  }
}

void _Unwind_SetGR(struct _Unwind_Context* context, int index, _Unwind_Word value) {
  if (index == 1) ((struct LandingPad*)context)->selector = value;
}

_Unwind_Word _Unwind_GetIP(struct _Unwind_Context* context) {
  return ((struct LandingPad*)context)->index + 2;
}

void _Unwind_SetIP(struct _Unwind_Context* context, _Unwind_Word value) {
  (void)context;
  (void)value;
}

void* _Unwind_GetLanguageSpecificData(struct _Unwind_Context* context) {
  return (void*)((struct LandingPad*)context)->lsda;
}

_Unwind_Ptr _Unwind_GetRegionStart(struct _Unwind_Context* context) {
  (void)context;
  return 0;
}

__asm__(
    ".globl __cpp_exception\n"
    ".tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");
