"""Evidence on an emitted folder, by tools that know nothing of how it was derived."""
