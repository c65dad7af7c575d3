"""The studio: the four crafts in the browser, served by this machine to itself."""
