"""Graph: the hook works the tree, stitch by stitch, into a StitchGraph; and what a tech edit finds in it."""
