"""Pictures: every common pixel format, read upright and in sRGB; a Drawing rasterised on writing."""

from __future__ import annotations

import io
import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.drawing import Drawing
from tambour.core.errors import TambourError
from tambour.core.picture import Picture
from tambour.files.sink import Sink

LARGEST = 200_000_000
"""Pixels above which a file is refused: a small file can claim any size."""


@contextmanager
def _quiet() -> Iterator[None]:
    """Silence the C libraries under Pillow, which write to the process's standard error by themselves."""
    keep, null = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(null, 2)
        yield
    finally:
        os.dup2(keep, 2)
        os.close(keep)
        os.close(null)


def read_picture(path: Path) -> Picture:
    """A Picture of the file's first frame, turned as its orientation tag says, converted to sRGB.

    Raises TambourError when the file is broken, no picture, or above 200 million pixels, and for a phone's .heic where
    no library reads it.
    """
    from PIL import Image, ImageCms, ImageOps

    if path.suffix.lower() in (".heic", ".heif"):
        _register_heif(path)

    Image.MAX_IMAGE_PIXELS = None  # the limit is ours, below
    try:
        with _quiet(), warnings.catch_warnings(), path.open("rb") as stream:
            warnings.simplefilter("ignore")
            image: Any = Image.open(stream)
            if image.width * image.height > LARGEST:
                size = f"{image.width} x {image.height}"
                raise TambourError(f"a picture of {size} pixels is too large", hint="scale it down", where=str(path))
            image.load()
            dpi = image.info.get("dpi", (0, 0))[0]
            profile = image.info.get("icc_profile")
            image = ImageOps.exif_transpose(image)
            if profile and image.mode in ("RGB", "CMYK", "L"):
                try:
                    source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
                    image = ImageCms.profileToProfile(image, source, ImageCms.createProfile("sRGB"), outputMode="RGB")
                except (ImageCms.PyCMSError, OSError):
                    pass  # a broken profile: the pixels are taken as sRGB, as every viewer does
            if image.mode.startswith("I") or image.mode == "F":
                image = _eight_bits(image)
            rgba = np.array(image.convert("RGBA"))
    except TambourError:
        raise
    except Exception as error:  # noqa: BLE001 - Pillow's readers raise whatever a hostile file makes them raise
        # Pillow names its own file object where it does not know the file; that says nothing to anyone.
        why = "" if "<_io" in str(error) else f" ({error or type(error).__name__})"
        raise TambourError(f"this is not a picture that can be read{why}", where=str(path)) from None
    if rgba.size == 0:
        raise TambourError("the picture has no pixels", where=str(path))
    return Picture(rgba, 25.4 / float(dpi) if 1 < float(dpi or 0) < 10_000 else None)


def _register_heif(path: Path) -> None:
    """Let Pillow open HEIF pictures, by pi-heif (libheif without its encoders)."""
    try:
        from pi_heif import register_heif_opener
    except ImportError:
        raise TambourError(
            "a phone's HEIF picture is read by pi-heif, which is not installed",
            hint='pip install "tambour[phone]", or save the picture as .jpg',
            where=str(path),
        ) from None
    register_heif_opener()


def _eight_bits(image: Any) -> Any:
    from PIL import Image

    values = np.asarray(image).astype(np.float64)
    top = 65535.0 if values.max(initial=0) > 255 else 255.0 if values.max(initial=0) > 1 else 1.0
    return Image.fromarray(np.round(np.clip(values / top, 0, 1) * 255).astype(np.uint8))


def write_picture(value: Picture, sink: Sink) -> None:
    """The format of the suffix; formats without transparency get a white ground."""
    from PIL import Image

    image = Image.fromarray(value.rgba)
    suffix = sink.suffix
    opaque = bool((value.rgba[..., 3] == 255).all())
    if opaque:
        image = image.convert("RGB")
    elif suffix in (".jpg", ".jpeg", ".bmp"):
        image = Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")
    options: dict[str, Any] = {}
    if value.pixel and suffix in (".png", ".jpg", ".jpeg", ".tif", ".tiff"):
        options["dpi"] = (25.4 / value.pixel,) * 2
    if suffix == ".png":
        options["compress_level"] = 3  # a third of the default's time, within a few per cent of its size
    if suffix in (".jpg", ".jpeg"):
        options |= {"quality": 92, "subsampling": 0}
    elif suffix == ".webp":
        options["lossless"] = True
    made = io.BytesIO()
    image.save(made, Image.registered_extensions()[suffix], **options)
    sink.put(made.getvalue())


def write_drawing(value: Drawing | tuple[Drawing, ...], sink: Sink) -> None:
    """A Drawing as pixels; the pages of a booklet, or the tiles of a stream, as name-1.png, name-2.png and so on."""
    from tambour.render.flat import picture

    if isinstance(value, Drawing):
        write_picture(picture(value), sink)
        return
    for number, page in enumerate(value, 1):
        write_picture(picture(page), sink.beside(f"{sink.path.stem}-{number}"))
