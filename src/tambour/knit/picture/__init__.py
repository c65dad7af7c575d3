"""Picture: from pixels to what each stitch should be."""
