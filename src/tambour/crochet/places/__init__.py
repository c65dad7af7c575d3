"""Places: where parts and faces go, from what people say and from what is usual."""
