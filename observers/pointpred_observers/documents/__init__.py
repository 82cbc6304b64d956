"""Plants and designs as JSON: written, read, and audited again."""
