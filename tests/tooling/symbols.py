"""What compiled simulation code may call: any mathematical function but sqrt may differ from one C library to another."""

import re
import subprocess

ALLOWED = re.compile(
    r"sqrt"
    r"|_Z\w+"  # C++: ours, and the standard library's; <cmath> itself calls C's functions, which have plain names
    r"|__cxa_\w+|__gxx_personality_v0|_Unwind_Resume|DW\.ref\.__gxx_personality_v0"  # exceptions of the containers
    r"|mem(chr|cmp|cpy|move|set)|bcmp|strlen"
    r"|__(memcpy|memmove|memset|strcpy)_chk|__stack_chk_fail|abort|__assert_fail|__glibcxx_assert_fail"
    r"|_GLOBAL_OFFSET_TABLE_|__dso_handle"
)


def forbidden(paths):
    """The undefined symbols of object files or archives that are not allowed, sorted."""
    output = subprocess.run(["nm", "-u", *paths], check=True, capture_output=True, text=True).stdout
    names = {match[1] for match in re.finditer(r"^\s+[Uw] (\S+)$", output, re.MULTILINE)}
    return sorted(name for name in names if not ALLOWED.fullmatch(name))
