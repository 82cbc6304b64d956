"""From rows to trials: cut, group, check, and describe them."""
