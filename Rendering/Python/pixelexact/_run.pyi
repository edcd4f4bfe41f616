from typing import Any, Callable, Optional

def update(
    algorithm: Any,
    progress: Optional[Callable[[float], object]],
    may_release: bool,
    information_only: bool = ...,
) -> tuple[list[str], list[str]]: ...
def set_threads(count: int) -> None: ...
def get_threads() -> int: ...
