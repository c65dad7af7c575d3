"""Work: pieces made in processes of their own, which are started once, kept warm, watched and killed."""
